// What bench/forms.comp is specialised for; read by GLSL and C++.
#ifdef __cplusplus
#pragma once
#endif

#define SPEC_FORM 0
#define SPEC_FORM_MODEL 1
#define SPEC_FORM_VARIANT 2
#define SPEC_FORM_REPEATS 3
#define SPEC_FORM_MODELS 4  // LOBE_* bits of FORM_LOBE

#define FORM_NONE 0      // the loop alone
#define FORM_ROBUST 1    // the model's own file
#define FORM_TEXTBOOK 2  // bench/textbook/textbook.glsl
#define FORM_LOBE 3      // the lobe code that pictures are shaded with, without the packed lobe's scale
