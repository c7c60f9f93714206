#pragma once
// We are wrong: CHECK is always on, DCHECK only where VAMP_DCHECK is defined (hot paths).

namespace vamp {
[[noreturn]] void check_failed(const char* file, int line, const char* condition);
}

#define CHECK(condition) ((condition) ? void(0) : ::vamp::check_failed(__FILE__, __LINE__, #condition))
#ifdef VAMP_DCHECK
#define DCHECK(condition) CHECK(condition)
#else
#define DCHECK(condition) void(0)
#endif
