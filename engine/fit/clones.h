#pragma once
// The few loops that all of a fit's time goes into are compiled for several generations of processors, and the loader
// picks one; the rest of the program stays plain x86-64. The sanitizers cannot run the loader's choice.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define VAMP_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default"), flatten))
#else
#define VAMP_CLONES
#endif
