#include "image/mappedfile.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>

namespace dsphere {
namespace {

// The signal comes to the thread that reads, and its handler gets no other argument than the address.
thread_local MappedFile* newest_of_thread = nullptr;

void onBusError(int signal, siginfo_t* info, void*) {
    if (newest_of_thread && newest_of_thread->replacePage(info->si_addr)) return;
    std::signal(signal, SIG_DFL);  // the access faults again, and ends the program
}

void installHandler() {
    struct sigaction action {};
    action.sa_sigaction = onBusError;
    action.sa_flags = SA_SIGINFO;
    sigaction(SIGBUS, &action, nullptr);
}

}  // namespace

std::unique_ptr<MappedFile> MappedFile::open(const std::filesystem::path& path, std::size_t size) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return nullptr;
    void* data = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor, 0);
    close(descriptor);
    return data == MAP_FAILED ? nullptr : std::unique_ptr<MappedFile>(new MappedFile(data, size));
}

MappedFile::MappedFile(void* data, std::size_t size) : data_(data), size_(size), previous_(newest_of_thread) {
    installHandler();
    newest_of_thread = this;
}

MappedFile::~MappedFile() {
    newest_of_thread = previous_;
    munmap(data_, size_);
}

void MappedFile::forget() const {
    madvise(data_, size_, MADV_DONTNEED);
}

bool MappedFile::replacePage(const void* address) {
    const auto begin = reinterpret_cast<std::uintptr_t>(data_), at = reinterpret_cast<std::uintptr_t>(address);
    if (at < begin || at - begin >= size_) return previous_ && previous_->replacePage(address);
    const auto page_bytes = std::uintptr_t(sysconf(_SC_PAGESIZE));
    void* page = reinterpret_cast<void*>(at / page_bytes * page_bytes);
    cut_ = 1;
    return mmap(page, page_bytes, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0) != MAP_FAILED;
}

}  // namespace dsphere
