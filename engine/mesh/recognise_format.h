#pragma once

#include <string_view>

namespace ossuary::mesh {

/// Model formats that can be told by their contents.
enum class ModelFormat {
    kUnknown,
    kOff,
    kStlText,
    kStlBinary,
    kPly,
    kObj,
    kXyz,  ///< points as text
    kGltfText,
    kGltfBinary,
    kVrml,
    kThreeMf,
    kZip,  ///< any other ZIP archive
    kCollada,
    kX3d,
    kAmf,
    kXml,  ///< anything else in XML
    kFbx,  ///< binary or text
    kStep,
    kIges,
    kGeomview,  ///< objects of other kinds than OFF
};

/// What the bytes look like, whatever the file is called.
[[nodiscard]] ModelFormat recognise_format(std::string_view bytes);

/// The format's name for messages.
[[nodiscard]] std::string_view to_string(ModelFormat format);

}  // namespace ossuary::mesh
