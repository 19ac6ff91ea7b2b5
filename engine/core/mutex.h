#pragma once

#include <mutex>
#include <shared_mutex>

// What a mutex guards, said so that clang's -Wthread-safety holds the code to it (the `clang`
// preset); for other compilers the words mean nothing.
#if defined(__clang__)
#define OSSUARY_THREAD_ATTRIBUTE(...) __attribute__((__VA_ARGS__))
#else
#define OSSUARY_THREAD_ATTRIBUTE(...)
#endif
/// A member that is touched only under this mutex.
#define OSSUARY_GUARDED_BY(mutex) OSSUARY_THREAD_ATTRIBUTE(guarded_by(mutex))
/// A function, or a condition's predicate, that is called only under this mutex.
#define OSSUARY_REQUIRES(mutex) OSSUARY_THREAD_ATTRIBUTE(requires_capability(mutex))
#define OSSUARY_REQUIRES_SHARED(mutex) OSSUARY_THREAD_ATTRIBUTE(requires_shared_capability(mutex))
/// A function that stands for its caller's having this mutex, where that cannot be seen.
#define OSSUARY_ASSERTS_SHARED(mutex) OSSUARY_THREAD_ATTRIBUTE(assert_shared_capability(mutex))
/// A function that hands out this mutex.
#define OSSUARY_RETURNS_MUTEX(mutex) OSSUARY_THREAD_ATTRIBUTE(lock_returned(mutex))

namespace ossuary {

/// std::mutex with its attributes.
class OSSUARY_THREAD_ATTRIBUTE(capability("mutex")) Mutex {
public:
    void lock() OSSUARY_THREAD_ATTRIBUTE(acquire_capability()) { mutex_.lock(); }
    void unlock() OSSUARY_THREAD_ATTRIBUTE(release_capability()) { mutex_.unlock(); }

private:
    std::mutex mutex_;
};

/// std::shared_mutex with its attributes.
class OSSUARY_THREAD_ATTRIBUTE(capability("mutex")) SharedMutex {
public:
    void lock() OSSUARY_THREAD_ATTRIBUTE(acquire_capability()) { mutex_.lock(); }
    void unlock() OSSUARY_THREAD_ATTRIBUTE(release_capability()) { mutex_.unlock(); }
    void lock_shared() OSSUARY_THREAD_ATTRIBUTE(acquire_shared_capability()) {
        mutex_.lock_shared();
    }
    void unlock_shared() OSSUARY_THREAD_ATTRIBUTE(release_shared_capability()) {
        mutex_.unlock_shared();
    }

private:
    std::shared_mutex mutex_;
};

/// Holds a mutex from construction to destruction, but for what lies between `unlock` and `lock`.
/// Made for std::condition_variable_any too.
template <typename Lockable>
class OSSUARY_THREAD_ATTRIBUTE(scoped_lockable) BasicLock {
public:
    explicit BasicLock(Lockable& mutex) OSSUARY_THREAD_ATTRIBUTE(acquire_capability(mutex))
        : mutex_(mutex) {
        mutex_.lock();
    }
    ~BasicLock() OSSUARY_THREAD_ATTRIBUTE(release_capability()) {
        if (held_) mutex_.unlock();
    }
    BasicLock(const BasicLock&) = delete;
    BasicLock& operator=(const BasicLock&) = delete;

    void lock() OSSUARY_THREAD_ATTRIBUTE(acquire_capability()) {
        mutex_.lock();
        held_ = true;
    }
    void unlock() OSSUARY_THREAD_ATTRIBUTE(release_capability()) {
        held_ = false;
        mutex_.unlock();
    }

private:
    Lockable& mutex_;
    bool held_ = true;
};
using Lock = BasicLock<Mutex>;
using ExclusiveLock = BasicLock<SharedMutex>;

/// Holds a mutex together with others who only look.
class OSSUARY_THREAD_ATTRIBUTE(scoped_lockable) SharedLock {
public:
    explicit SharedLock(SharedMutex& mutex)
        OSSUARY_THREAD_ATTRIBUTE(acquire_shared_capability(mutex))
        : mutex_(mutex) {
        mutex_.lock_shared();
    }
    ~SharedLock() OSSUARY_THREAD_ATTRIBUTE(release_capability()) { mutex_.unlock_shared(); }
    SharedLock(const SharedLock&) = delete;
    SharedLock& operator=(const SharedLock&) = delete;

private:
    SharedMutex& mutex_;
};

}  // namespace ossuary
