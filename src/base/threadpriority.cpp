#include "base/threadpriority.h"

#ifdef __linux__
#include <sys/resource.h>
#endif

namespace dsphere {

void stepBack() {
#ifdef __linux__
    constexpr int kNice = 5;
    setpriority(PRIO_PROCESS, 0, kNice);  // of Linux's "process" 0, which is the thread
#endif
}

}  // namespace dsphere
