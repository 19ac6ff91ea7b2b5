#pragma once

#include <Common/NMR_ErrorConst.h>
#include <Model/COM/NMR_DLLInterfaces.h>

#include <memory>

// Objects of lib3mf's, which are given back when nothing holds them any more.
namespace ossuary::index::three_mf {

struct Release {
    void operator()(NMR::PLib3MFBase* instance) const { NMR::lib3mf_release(instance); }
};
using Instance = std::unique_ptr<NMR::PLib3MFBase, Release>;

/// What a call hands over through its last argument.
template <typename Call>
Instance made_by(Call call) {
    NMR::PLib3MFBase* made = nullptr;
    if (call(&made) != LIB3MF_OK) made = nullptr;
    return Instance(made);
}

}  // namespace ossuary::index::three_mf
