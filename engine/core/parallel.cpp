#include "engine/core/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace ossuary {
namespace {

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define OSSUARY_THREAD_SANITIZER 1
#endif
#endif

#ifdef OSSUARY_THREAD_SANITIZER
/// TBB's library is not instrumented: the sanitizer would not see the order that it makes, and take
/// every use of a result for a race.
void run_parallel(std::size_t count, int workers, const std::function<void(std::size_t)>& body) {
    std::atomic<std::size_t> next = 0;
    std::vector<std::jthread> threads;
    for (int worker = 0; worker < workers; ++worker) {
        threads.emplace_back([&] {
            for (std::size_t i = next++; i < count; i = next++) body(i);
        });
    }
}
#else
void run_parallel(std::size_t count, int workers, const std::function<void(std::size_t)>& body) {
    tbb::task_arena arena(workers);
    arena.execute([&] {
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, count, 1),
            [&](const tbb::blocked_range<std::size_t>& range) {
                for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
            },
            tbb::simple_partitioner());
    });
}
#endif

}  // namespace

int resolve_jobs(int jobs) {
    if (jobs > 0) return jobs;
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void parallel_for(std::size_t count, int jobs, const std::function<void(std::size_t)>& body) {
    const int workers = resolve_jobs(jobs);
    if (workers == 1 || count < 2) {
        for (std::size_t i = 0; i < count; ++i) body(i);
        return;
    }
    run_parallel(count, workers, body);
}

}  // namespace ossuary
