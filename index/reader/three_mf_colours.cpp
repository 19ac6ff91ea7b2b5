#include "index/reader/three_mf_colours.h"

#include <map>
#include <utility>

namespace ossuary::index {
namespace {

using mesh::Colour;
using mesh::CornerColours;
using three_mf::Instance;
using three_mf::made_by;

Colour colour_from(const NMR::MODELMESHCOLOR_SRGB& colour) {
    return {colour.m_Red, colour.m_Green, colour.m_Blue};
}

/// The colours of a model's base materials, each looked up once.
class BaseMaterials {
public:
    explicit BaseMaterials(NMR::PLib3MFBase* model) : model_(model) {}

    std::optional<Colour> colour(DWORD group, DWORD index) {
        const auto [known, is_new] = known_.try_emplace({group, index});
        if (is_new) known->second = look_up(group, index);
        return known->second;
    }

private:
    [[nodiscard]] std::optional<Colour> look_up(DWORD group, DWORD index) const {
        const Instance materials = made_by([&](auto** made) {
            return NMR::lib3mf_model_getbasematerialbyid(model_, group, made);
        });
        BYTE red = 0, green = 0, blue = 0, alpha = 0;
        if (!materials || NMR::lib3mf_basematerial_getdisplaycolor(
                              materials.get(), index, &red, &green, &blue, &alpha) != LIB3MF_OK) {
            return {};
        }
        return Colour{red, green, blue};
    }

    NMR::PLib3MFBase* model_;
    std::map<std::pair<DWORD, DWORD>, std::optional<Colour>> known_;
};

CornerColours flat(const Colour& colour) { return {colour, colour, colour}; }

/// What an object says for all its triangles.
std::optional<CornerColours> object_colours(NMR::PLib3MFBase* object, BaseMaterials& materials) {
    const Instance handler = made_by(
        [&](auto** made) { return NMR::lib3mf_object_createdefaultpropertyhandler(object, made); });
    NMR::eModelPropertyType type = NMR::MODELPROPERTYTYPE_NONE;
    if (!handler ||
        NMR::lib3mf_defaultpropertyhandler_getpropertytype(handler.get(), &type) != LIB3MF_OK) {
        return {};
    }
    if (type == NMR::MODELPROPERTYTYPE_COLOR) {
        NMR::MODELMESHCOLOR_SRGB colour{};
        if (NMR::lib3mf_defaultpropertyhandler_getcolor(handler.get(), 0, &colour) != LIB3MF_OK) {
            return {};
        }
        return flat(colour_from(colour));
    }
    DWORD group = 0, index = 0;
    if (type != NMR::MODELPROPERTYTYPE_BASEMATERIALS ||
        NMR::lib3mf_defaultpropertyhandler_getbasematerial(handler.get(), &group, &index) !=
            LIB3MF_OK) {
        return {};
    }
    const auto colour = materials.colour(group, index);
    return colour ? std::optional(flat(*colour)) : std::nullopt;
}

std::optional<CornerColours> triangle_colours(NMR::PLib3MFBase* handler, DWORD triangle,
                                              BaseMaterials& materials) {
    NMR::eModelPropertyType type = NMR::MODELPROPERTYTYPE_NONE;
    if (NMR::lib3mf_propertyhandler_getpropertytype(handler, triangle, &type) != LIB3MF_OK) {
        return {};
    }
    if (type == NMR::MODELPROPERTYTYPE_COLOR) {
        NMR::MODELMESH_TRIANGLECOLOR_SRGB colours{};
        if (NMR::lib3mf_propertyhandler_getcolor(handler, triangle, &colours) != LIB3MF_OK) {
            return {};
        }
        return CornerColours{colour_from(colours.m_Colors[0]), colour_from(colours.m_Colors[1]),
                             colour_from(colours.m_Colors[2])};
    }
    DWORD group = 0, index = 0;
    if (type != NMR::MODELPROPERTYTYPE_BASEMATERIALS ||
        NMR::lib3mf_propertyhandler_getbasematerial(handler, triangle, &group, &index) !=
            LIB3MF_OK) {
        return {};
    }
    const auto colour = materials.colour(group, index);
    return colour ? std::optional(flat(*colour)) : std::nullopt;
}

}  // namespace

ThreeMfColours three_mf_colours(NMR::PLib3MFBase* model, NMR::PLib3MFBase* object,
                                std::uint32_t triangles) {
    BaseMaterials materials(model);
    const auto whole = object_colours(object, materials);
    const Instance handler = made_by(
        [&](auto** made) { return NMR::lib3mf_meshobject_createpropertyhandler(object, made); });
    ThreeMfColours colours(triangles, whole);
    bool any = whole.has_value();
    for (DWORD t = 0; handler && t < triangles; ++t) {
        const auto own = triangle_colours(handler.get(), t, materials);
        if (!own) continue;
        colours[t] = own;
        any = true;
    }
    if (!any) colours.clear();
    return colours;
}

}  // namespace ossuary::index
