#include "tests/index/earlier_versions.h"

#include "index/bytes.h"

namespace ossuary::test {

std::string sealed_as(const index::BlobKind& kind, std::uint8_t version, std::string_view payload) {
    return index::seal_blob({kind.mark, version}, payload);
}

std::string earlier_preview(const index::PreviewMesh& mesh, std::uint8_t version) {
    index::ByteWriter writer;
    writer.put(static_cast<std::uint32_t>(mesh.positions.size() / 3));
    writer.put(static_cast<std::uint32_t>(mesh.triangles.size() / 3));
    writer.put(std::uint8_t{2});
    for (const double coordinate : mesh.origin) writer.put(coordinate);
    writer.put_all<float>(mesh.positions);
    for (const std::uint32_t corner : mesh.triangles) {
        writer.put(static_cast<std::uint16_t>(corner));
    }
    if (version >= 3) {
        writer.put(static_cast<std::uint8_t>(mesh.colours.of));
        writer.put_all<std::uint8_t>(mesh.colours.bytes);
    }
    return sealed_as(index::kPreviewBlob, version, writer.bytes());
}

std::string earlier_descriptor(const matching::SkeletonDescriptor& descriptor,
                               std::uint8_t version) {
    index::ByteWriter writer;
    if (version == 2) writer.put(descriptor.solid_volume);
    writer.put(static_cast<std::uint32_t>(descriptor.nodes.size()));
    for (const matching::SkeletonDescriptor::Node& node : descriptor.nodes) {
        for (const float coordinate : node.position) writer.put(coordinate);
        writer.put(node.radius);
        writer.put(node.significance);
    }
    writer.put(static_cast<std::uint32_t>(descriptor.branches.size()));
    for (const matching::SkeletonDescriptor::Branch& branch : descriptor.branches) {
        writer.put(branch.a);
        writer.put(branch.b);
        writer.put(branch.length);
        writer.put_text(branch.chain_code);
        writer.put(static_cast<std::uint32_t>(branch.radii.size()));
        writer.put_all<float>(branch.points);
        writer.put_all<float>(branch.radii);
    }
    return sealed_as(index::kDescriptorBlob, version, writer.bytes());
}

}  // namespace ossuary::test
