#include "index/reader/read_cad.h"

#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <IGESControl_Reader.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Poly_Triangulation.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <array>
#include <istream>
#include <memory>
#include <span>
#include <streambuf>
#include <string>
#include <utility>
#include <vector>

#include "index/reader/iges_file.h"
#include "index/reader/scene_builder.h"

namespace ossuary::index {
namespace {

/// Bytes in memory as a stream.
class ViewBuffer : public std::streambuf {
public:
    explicit ViewBuffer(std::string_view bytes) {
        char* begin = const_cast<char*>(bytes.data());  // which setg asks for and nobody writes to
        setg(begin, begin, begin + bytes.size());
    }
};

Error invalid(mesh::ModelFormat format, const std::string& found) {
    return {ErrorCode::kSceneInvalid,
            "expected a " + std::string(to_string(format)) + " file, found " + found};
}

/// OpenCASCADE takes what there is of a file for the whole.
bool is_whole(std::string_view bytes, mesh::ModelFormat format) {
    if (format == mesh::ModelFormat::kStep) {
        return bytes.rfind("END-ISO-10303-21") != std::string_view::npos;
    }
    // The last line ends with T and its number.
    const std::size_t last = bytes.find_last_not_of("\r\n \t\0");
    constexpr std::size_t kNumber = 7;
    const std::size_t mark = bytes.find_last_of("ST", last);
    return mark != std::string_view::npos && bytes[mark] == 'T' && last - mark <= kNumber;
}

class CadReader {
public:
    explicit CadReader(const mesh::ReadMeshOptions& caps)
        : scene_(caps, SceneBuilder::Corners::kJoin) {}

    Result<mesh::ReadMeshResult> read(std::string_view bytes, mesh::ModelFormat format);

private:
    Result<TopoDS_Shape> open(std::string_view bytes, mesh::ModelFormat format);
    [[nodiscard]] std::string name_of(const TopoDS_Shape& solid) const;
    Result<void> add_object(const TopoDS_Shape& shape, std::string name, TopAbs_ShapeEnum outside);
    Result<void> add_face(const TopoDS_Face& face);

    std::unique_ptr<XSControl_Reader> reader_;
    SceneBuilder scene_;
    std::size_t faces_without_triangles_ = 0;
};

Result<TopoDS_Shape> CadReader::open(std::string_view bytes, mesh::ModelFormat format) {
    IFSelect_ReturnStatus status = IFSelect_RetVoid;
    if (format == mesh::ModelFormat::kStep) {
        reader_ = std::make_unique<STEPControl_Reader>();
        ViewBuffer buffer(bytes);
        std::istream stream(&buffer);
        status = reader_->ReadStream("model.stp", stream);
    } else {
        reader_ = std::make_unique<IGESControl_Reader>();
        const IgesFile file(bytes);
        status = reader_->ReadFile(kIgesFile);
    }
    if (status != IFSelect_RetDone) return invalid(format, "one that cannot be read");
    reader_->TransferRoots();
    TopoDS_Shape shape = reader_->OneShape();
    if (shape.IsNull()) return invalid(format, "one without shapes");
    return shape;
}

/// Of the entity that it was made from.
std::string CadReader::name_of(const TopoDS_Shape& solid) const {
    const auto transfer = reader_->WS()->TransferReader();
    for (const TopoDS_Shape& shape : {solid, solid.Located(TopLoc_Location())}) {
        const auto item = Handle(StepRepr_RepresentationItem)::DownCast(
            transfer->EntityFromShapeResult(shape, 1));
        if (!item.IsNull() && !item->Name().IsNull()) return item->Name()->ToCString();
    }
    return {};
}

Result<void> CadReader::add_face(const TopoDS_Face& face) {
    TopLoc_Location location;
    const Handle(Poly_Triangulation) triangulation = BRep_Tool::Triangulation(face, location);
    if (triangulation.IsNull()) {
        ++faces_without_triangles_;
        return {};
    }
    const gp_Trsf placed = location.Transformation();
    std::vector<std::uint32_t> numbers;
    numbers.reserve(static_cast<std::size_t>(triangulation->NbNodes()));
    for (int i = 1; i <= triangulation->NbNodes(); ++i) {
        const gp_Pnt point = triangulation->Node(i).Transformed(placed);
        const auto number = scene_.add_vertex({point.X(), point.Y(), point.Z()});
        if (!number) return number.error();
        numbers.push_back(*number);
    }
    const bool turned = (face.Orientation() == TopAbs_REVERSED) != placed.IsNegative();
    for (int i = 1; i <= triangulation->NbTriangles(); ++i) {
        std::array<int, 3> nodes{};
        triangulation->Triangle(i).Get(nodes[0], nodes[1], nodes[2]);
        std::array<std::uint32_t, 3> corners{};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const auto node = static_cast<std::size_t>(nodes[corner] - 1);
            if (node >= numbers.size()) {
                return {ErrorCode::kSceneInvalid, "expected corners that are nodes, found others"};
            }
            corners[corner] = numbers[node];
        }
        if (turned) std::swap(corners[1], corners[2]);
        if (auto added = scene_.add_face(corners); !added) return added;
    }
    return {};
}

/// @param outside  faces in shapes of this kind are left to these
Result<void> CadReader::add_object(const TopoDS_Shape& shape, std::string name,
                                   TopAbs_ShapeEnum outside) {
    scene_.begin_object(std::move(name));
    for (TopExp_Explorer face(shape, TopAbs_FACE, outside); face.More(); face.Next()) {
        if (auto added = add_face(TopoDS::Face(face.Current())); !added) return added;
    }
    scene_.end_object();
    return {};
}

Result<mesh::ReadMeshResult> CadReader::read(std::string_view bytes, mesh::ModelFormat format) {
    const auto shape = open(bytes, format);
    if (!shape) return shape.error();
    Bnd_Box box;
    BRepBndLib::AddClose(*shape, box);
    if (!box.IsVoid()) {
        const double diagonal = box.CornerMin().Distance(box.CornerMax());
        BRepMesh_IncrementalMesh(*shape, kCadDeviation * diagonal, false, kCadAngle, false);
    }
    for (TopExp_Explorer solid(*shape, TopAbs_SOLID); solid.More(); solid.Next()) {
        auto added = add_object(solid.Current(), name_of(solid.Current()), TopAbs_SHAPE);
        if (!added) return added.error();
    }
    if (auto added = add_object(*shape, "", TopAbs_SOLID); !added) return added.error();
    scene_.warn("faces_without_triangles", faces_without_triangles_,
                mesh::plural(faces_without_triangles_, "face") + " that could not be cut up");
    mesh::ReadMeshResult read = scene_.take();
    constexpr double kMillimetre = 1e-3;
    read.metres_per_unit = kMillimetre;
    read.up = mesh::UpAxis::kZ;
    return read;
}

}  // namespace

Result<mesh::ReadMeshResult> read_cad(std::string_view bytes, mesh::ModelFormat format,
                                      const mesh::ReadMeshOptions& caps) {
    if (!is_whole(bytes, format)) return invalid(format, "one that ends early");
    try {
        const Handle(Message_Messenger) messenger = Message::DefaultMessenger();
        messenger->ChangePrinters().Clear();
        return CadReader(caps).read(bytes, format);
    } catch (const Standard_Failure& failure) {
        const char* why = failure.GetMessageString();
        return invalid(
            format,
            "one that cannot be used: " +
                std::string(why == nullptr || *why == '\0' ? failure.DynamicType()->Name() : why));
    }
}

}  // namespace ossuary::index
