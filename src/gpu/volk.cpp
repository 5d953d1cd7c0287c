// The one place where volk's loader code is compiled.
#define VOLK_IMPLEMENTATION
#include <volk.h>
