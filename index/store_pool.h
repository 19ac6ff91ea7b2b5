#pragma once

#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

#include "engine/core/mutex.h"
#include "engine/core/result.h"
#include "index/store.h"

namespace ossuary::index {

/// Stores that read one index, so that readers do not wait for each other: one is made whenever all
/// are in use. Safe to use from several threads.
class StorePool {
public:
    /// A store on loan; back in the pool at the end of its life.
    class Loan {
    public:
        Loan(StorePool& pool, std::unique_ptr<Store> store)
            : pool_(&pool), store_(std::move(store)) {}
        Loan(Loan&&) noexcept = default;
        Loan& operator=(Loan&&) = delete;
        ~Loan() {
            if (store_) pool_->take_back(std::move(store_));
        }
        Store& operator*() const { return *store_; }
        Store* operator->() const { return store_.get(); }

    private:
        StorePool* pool_;
        std::unique_ptr<Store> store_;
    };

    /// @param first  says where the index is and whether replacements are followed; outlives this
    explicit StorePool(Store& first) : first_(first) {}

    /// Errors: those of Store::open.
    Result<Loan> lend();

private:
    void take_back(std::unique_ptr<Store> store);

    Store& first_;
    Mutex mutex_;
    std::vector<std::unique_ptr<Store>> idle_ OSSUARY_GUARDED_BY(mutex_);
};

}  // namespace ossuary::index
