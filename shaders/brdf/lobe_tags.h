// The bits that say what a lobe is and what a kernel can do; read by shaders/brdf/lobe.glsl and engine/brdf/pack.cpp.
#ifndef LOBE_TAGS_H
#define LOBE_TAGS_H

// Bits of LOBE_MODELS. The first seven are the models' usual forms in the order of Model; the rest cost extra and serve
// variants that few materials have.
#define LOBE_LAMBERT 1u
#define LOBE_OREN_NAYAR 2u
#define LOBE_BLINN_PHONG 4u
#define LOBE_WARD 8u
#define LOBE_COOK_TORRANCE 16u
#define LOBE_LAFORTUNE 32u
#define LOBE_ASHIKHMIN_SHIRLEY 64u
#define LOBE_OREN_NAYAR_FULL 128u
#define LOBE_WARD_IMPORTED 256u
#define LOBE_FRESNEL_EXACT 512u
#define LOBE_ASHIKHMIN_SHIRLEY_BASE 1024u
#define LOBE_EVERYTHING 2047u

// Bits of a tag: the path, then flags. Bits 16-18 repeat the model and 20-23 the variant, for overlays; no code here
// reads those.
#define LOBE_TAG_DIFFUSE 1u      // Lambert, Oren-Nayar qualitative
#define LOBE_TAG_FULL 2u         // Oren-Nayar full
#define LOBE_TAG_LAFORTUNE 4u    // q = n log2(1 / x)
#define LOBE_TAG_POWER 8u        // q = exponent * log2(1 + tan^2); else q = slopes^2 / alpha^2
#define LOBE_TAG_WIDTH 16u       // times S^2 / Sz^4: Ward and Cook-Torrance
#define LOBE_TAG_GROOVE 32u      // Cook-Torrance's masking
#define LOBE_TAG_MAXCOS 64u      // Ashikhmin-Shirley's 1 / (oh max(iz, oz))
#define LOBE_TAG_SQRT 128u       // Ward 1992: sqrt(iz / oz)
#define LOBE_TAG_DUER 256u       // Duer: 1 / oz
#define LOBE_TAG_EXACT 512u      // exact Fresnel instead of Schlick's
#define LOBE_TAG_BASE_ONLY 1024u  // no highlight
#define LOBE_TAG_MODEL_SHIFT 16
#define LOBE_TAG_VARIANT_SHIFT 20

#endif
