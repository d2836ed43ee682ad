// Writes shapes as model files of every format that can be read, in memory, so that the readers can be tested
// without files from elsewhere.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "core/mesh/soup.h"

namespace netwright::testing {

inline std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

inline void write_file(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

/// Appends a value as it lies in memory (little-endian here).
template <class T>
void append(std::string& bytes, T value) {
  std::array<char, sizeof(T)> raw{};
  std::memcpy(raw.data(), &value, sizeof value);
  bytes.append(raw.data(), raw.size());
}

inline const glm::dvec3& corner(const PolygonSoup& soup, int f, std::size_t i) {
  return soup.points[static_cast<std::size_t>(soup.face(f)[i])];
}

inline std::string to_binary_stl(const PolygonSoup& soup, std::string header = "binary") {
  header.resize(80, ' ');
  append(header, static_cast<std::uint32_t>(soup.n_faces()));
  for (int f = 0; f < soup.n_faces(); ++f) {
    for (int i = 0; i < 3; ++i) append(header, 0.0F);
    for (std::size_t i = 0; i < 3; ++i) {
      for (int axis = 0; axis < 3; ++axis) append(header, static_cast<float>(corner(soup, f, i)[axis]));
    }
    append(header, std::uint16_t{0});
  }
  return header;
}

inline std::string to_text_stl(const PolygonSoup& soup) {
  std::ostringstream text;
  text << "solid shape\n";
  for (int f = 0; f < soup.n_faces(); ++f) {
    text << "facet normal 0 0 0\nouter loop\n";
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec3 p = corner(soup, f, i);
      text << "vertex " << p.x << " " << p.y << " " << p.z << "\n";
    }
    text << "endloop\nendfacet\n";
  }
  text << "endsolid shape\n";
  return text.str();
}

inline std::string to_text_ply(const PolygonSoup& soup) {
  std::ostringstream text;
  text << "ply\nformat ascii 1.0\nelement vertex " << soup.points.size()
       << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << soup.n_faces()
       << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const glm::dvec3& p : soup.points) text << p.x << " " << p.y << " " << p.z << "\n";
  for (int f = 0; f < soup.n_faces(); ++f) {
    text << soup.face(f).size();
    for (const int point : soup.face(f)) text << " " << point;
    text << "\n";
  }
  return text.str();
}

inline std::string to_binary_ply(const PolygonSoup& soup) {
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(soup.points.size()) +
      "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
      std::to_string(soup.n_faces()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const glm::dvec3& p : soup.points) {
    for (int axis = 0; axis < 3; ++axis) append(bytes, static_cast<float>(p[axis]));
  }
  for (int f = 0; f < soup.n_faces(); ++f) {
    append(bytes, static_cast<std::uint8_t>(soup.face(f).size()));
    for (const int point : soup.face(f)) append(bytes, point);
  }
  return bytes;
}

inline std::string to_off(const PolygonSoup& soup) {
  std::ostringstream text;
  text << "OFF\n# a comment\n" << soup.points.size() << " " << soup.n_faces() << " 0\n";
  for (const glm::dvec3& p : soup.points) text << p.x << " " << p.y << " " << p.z << "\n";
  for (int f = 0; f < soup.n_faces(); ++f) {
    text << soup.face(f).size();
    for (const int point : soup.face(f)) text << " " << point;
    text << "\n";
  }
  return text.str();
}

inline std::uint32_t crc32(const std::string& bytes) {
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~crc;
}

/// A zip archive whose members are stored as they are.
inline std::string to_zip(const std::vector<std::pair<std::string, std::string>>& members) {
  std::string bytes;
  std::string directory;
  for (const auto& [name, content] : members) {
    std::string common;  // what the local and the central header share
    append(common, std::uint16_t{20});
    append(common, std::uint64_t{0});  // flags, method "stored", time and date
    append(common, crc32(content));
    append(common, static_cast<std::uint32_t>(content.size()));
    append(common, static_cast<std::uint32_t>(content.size()));
    append(common, static_cast<std::uint16_t>(name.size()));
    append(common, std::uint16_t{0});
    directory.append("PK\x01\x02\x14\x00", 6).append(common).append(10, '\0');
    append(directory, static_cast<std::uint32_t>(bytes.size()));
    directory += name;
    bytes.append("PK\x03\x04").append(common).append(name).append(content);
  }
  const auto start = static_cast<std::uint32_t>(bytes.size());
  bytes += directory + "PK\x05\x06" + std::string(4, '\0');
  append(bytes, static_cast<std::uint16_t>(members.size()));
  append(bytes, static_cast<std::uint16_t>(members.size()));
  append(bytes, static_cast<std::uint32_t>(directory.size()));
  append(bytes, start);
  append(bytes, std::uint16_t{0});
  return bytes;
}

inline std::string to_dae(const PolygonSoup& soup) {
  std::ostringstream text;
  text
      << R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">)"
      << R"(<asset><up_axis>Y_UP</up_axis></asset><library_geometries><geometry id="g"><mesh>)"
      << R"(<source id="p"><float_array id="pa" count=")" << 3 * soup.points.size() << "\">";
  for (const glm::dvec3& p : soup.points) text << p.x << ' ' << p.y << ' ' << p.z << ' ';
  text
      << R"(</float_array><technique_common><accessor source="#pa" stride="3" count=")" << soup.points.size()
      << R"("><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>)"
      << R"(</accessor></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/>)"
      << R"(</vertices><polylist count=")" << soup.n_faces()
      << R"("><input semantic="VERTEX" source="#v" offset="0"/><vcount>)";
  for (int f = 0; f < soup.n_faces(); ++f) text << soup.face(f).size() << ' ';
  text << "</vcount><p>";
  for (const int corner : soup.corners) text << corner << ' ';
  text << R"(</p></polylist></mesh></geometry></library_geometries><library_visual_scenes>)"
       << R"(<visual_scene id="s"><node><instance_geometry url="#g"/></node></visual_scene>)"
       << R"(</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
  return text.str();
}

/// Triangles only.
inline std::string to_3ds(const PolygonSoup& soup) {
  const auto chunk = [](std::uint16_t id, const std::string& content) {
    std::string bytes;
    append(bytes, id);
    append(bytes, static_cast<std::uint32_t>(content.size() + 6));
    return bytes + content;
  };
  std::string points;
  append(points, static_cast<std::uint16_t>(soup.points.size()));
  for (const glm::dvec3& p : soup.points) {
    for (int i = 0; i < 3; ++i) append(points, static_cast<float>(p[i]));
  }
  std::string faces;
  append(faces, static_cast<std::uint16_t>(soup.n_faces()));
  for (int f = 0; f < soup.n_faces(); ++f) {
    for (const int corner : soup.face(f)) append(faces, static_cast<std::uint16_t>(corner));
    append(faces, std::uint16_t{7});
  }
  const std::string object =
      std::string("model") + '\0' + chunk(0x4100, chunk(0x4110, points) + chunk(0x4120, faces));
  return chunk(0x4D4D, chunk(0x3D3D, chunk(0x4000, object)));
}

/// A 3MF package around the text of its model.
inline std::string to_3mf_package(const std::string& model) {
  return to_zip(
      {{"[Content_Types].xml",
        R"(<?xml version="1.0"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">)"
        R"(<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>)"
        R"(<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>)"
        R"(</Types>)"},
       {"_rels/.rels",
        R"(<?xml version="1.0"?><Relationships )"
        R"(xmlns="http://schemas.openxmlformats.org/package/2006/relationships">)"
        R"(<Relationship Target="/3D/3dmodel.model" Id="rel0" )"
        R"(Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>)"},
       {"3D/3dmodel.model", model}});
}

/// Triangles only.
inline std::string to_3mf(const PolygonSoup& soup) {
  std::ostringstream model;
  model << R"(<?xml version="1.0" encoding="UTF-8"?><model unit="millimeter" )"
        << R"(xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>)"
        << R"(<object id="1" type="model"><mesh><vertices>)";
  for (const glm::dvec3& p : soup.points) {
    model << "<vertex x=\"" << p.x << "\" y=\"" << p.y << "\" z=\"" << p.z << "\"/>";
  }
  model << "</vertices><triangles>";
  for (int f = 0; f < soup.n_faces(); ++f) {
    const auto face = soup.face(f);
    model << "<triangle v1=\"" << face[0] << "\" v2=\"" << face[1] << "\" v3=\"" << face[2] << "\"/>";
  }
  model << R"(</triangles></mesh></object></resources><build><item objectid="1"/></build></model>)";
  return to_3mf_package(model.str());
}

/// The numbers of a glTF: positions as floats, then indices as 16-bit integers.
inline std::string gltf_buffer(const PolygonSoup& soup) {
  std::string bytes;
  for (const glm::dvec3& p : soup.points) {
    for (int axis = 0; axis < 3; ++axis) append(bytes, static_cast<float>(p[axis]));
  }
  for (const int point : soup.corners) append(bytes, static_cast<std::uint16_t>(point));
  bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
  return bytes;
}

/// The glTF text over gltf_buffer(): one mesh, drawn by the nodes given as JSON ({"mesh":0} is the plain
/// one).
inline std::string gltf_text(const PolygonSoup& soup, const std::string& nodes,
                             const std::string& buffer_uri) {
  const std::size_t n_points = soup.points.size();
  const std::size_t n_bytes = gltf_buffer(soup).size();
  std::ostringstream text;
  text << R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)" << nodes
       << R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"accessors":[)"
       << R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":)" << n_points
       << R"(},{"bufferView":1,"componentType":5123,"type":"SCALAR","count":)" << soup.corners.size()
       << R"(}],"bufferViews":[{"buffer":0,"byteLength":)" << 12 * n_points
       << R"(},{"buffer":0,"byteOffset":)" << 12 * n_points << R"(,"byteLength":)" << 2 * soup.corners.size()
       << R"(}],"buffers":[{"byteLength":)" << n_bytes;
  if (!buffer_uri.empty()) text << R"(,"uri":")" << buffer_uri << '"';
  text << "}]}";
  return text.str();
}

inline std::string to_glb(const PolygonSoup& soup, const std::string& nodes = R"({"mesh":0})") {
  std::string json = gltf_text(soup, nodes, "");
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string buffer = gltf_buffer(soup);
  std::string bytes = "glTF";
  append(bytes, std::uint32_t{2});
  append(bytes, static_cast<std::uint32_t>(28 + json.size() + buffer.size()));
  append(bytes, static_cast<std::uint32_t>(json.size()));
  bytes += "JSON" + json;
  append(bytes, static_cast<std::uint32_t>(buffer.size()));
  bytes += std::string("BIN\0", 4) + buffer;
  return bytes;
}

}  // namespace netwright::testing
