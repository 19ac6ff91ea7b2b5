#include "index/store_pool.h"

namespace ossuary::index {

Result<StorePool::Loan> StorePool::lend() {
    {
        const Lock lock(mutex_);
        if (!idle_.empty()) {
            Loan loan(*this, std::move(idle_.back()));
            idle_.pop_back();
            return loan;
        }
    }
    auto opened = Store::open(first_.path(), Access::kReadOnly);
    if (!opened) return opened.error();
    auto store = std::make_unique<Store>(*std::move(opened));
    if (first_.follows_replacements()) store->follow_replacements();
    return Loan(*this, std::move(store));
}

void StorePool::take_back(std::unique_ptr<Store> store) {
    const Lock lock(mutex_);
    idle_.push_back(std::move(store));
}

}  // namespace ossuary::index
