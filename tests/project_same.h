// What it means that two projects which share nothing are the same.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "core/base/image.h"
#include "core/project/project.h"

namespace netwright::testing {

inline void expect_same(const std::vector<Material>& a, const std::vector<Material>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].name, b[i].name);
    EXPECT_EQ(a[i].colour, b[i].colour);
    ASSERT_EQ(a[i].texture != nullptr, b[i].texture != nullptr);
    if (!a[i].texture) continue;
    EXPECT_EQ(a[i].texture->width, b[i].texture->width);
    EXPECT_EQ(a[i].texture->rgba, b[i].texture->rgba);
  }
}

inline void expect_same(const PolygonSoup& a, const PolygonSoup& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.up_axis, b.up_axis);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.face_begin, b.face_begin);
  EXPECT_EQ(a.corners, b.corners);
  EXPECT_EQ(a.is_indexed, b.is_indexed);
  EXPECT_EQ(a.is_joined, b.is_joined);
  EXPECT_EQ(a.corner_uv, b.corner_uv);
  EXPECT_EQ(a.face_material, b.face_material);
  EXPECT_EQ(a.notices, b.notices);
  expect_same(a.materials, b.materials);
}

inline void expect_same(const Mesh& a, const Mesh& b) {
  EXPECT_EQ(a.name(), b.name());
  EXPECT_EQ(a.up_axis(), b.up_axis());
  ASSERT_EQ(a.n_vertices(), b.n_vertices());
  ASSERT_EQ(a.n_faces(), b.n_faces());
  ASSERT_EQ(a.n_halfedges(), b.n_halfedges());
  ASSERT_EQ(a.n_edges(), b.n_edges());
  ASSERT_EQ(a.has_uv(), b.has_uv());
  for (const VertexId v : a.vertices()) EXPECT_EQ(a.position(v), b.position(v));
  for (const HalfedgeId h : a.halfedges()) {
    ASSERT_EQ(a.from(h), b.from(h));
    ASSERT_EQ(a.twin(h), b.twin(h));
    ASSERT_EQ(a.edge(h), b.edge(h));
    if (a.has_uv()) {
      EXPECT_EQ(a.uv(h), b.uv(h));
    }
  }
  for (const FaceId f : a.faces()) {
    ASSERT_EQ(a.first(f), b.first(f));
    EXPECT_EQ(a.face_source(f), b.face_source(f));
    EXPECT_EQ(a.is_flipped(f), b.is_flipped(f));
    EXPECT_EQ(a.material(f), b.material(f));
  }
  expect_same(a.materials(), b.materials());
}

inline void expect_same(const MadeModel& a, const MadeModel& b) {
  expect_same(a.dual->mesh(), b.dual->mesh());
  EXPECT_EQ(a.done, b.done);
  EXPECT_EQ(a.refusal, b.refusal);
  EXPECT_EQ(a.deviation, b.deviation);
  EXPECT_EQ(a.groups, b.groups);
  for (const EdgeId e : a.dual->mesh().edges()) EXPECT_EQ(a.dual->is_hidden(e), b.dual->is_hidden(e));
  EXPECT_EQ(a.n_faces_least, b.n_faces_least);
  ASSERT_EQ(a.report.lines.size(), b.report.lines.size());
  for (std::size_t i = 0; i < a.report.lines.size(); ++i)
    EXPECT_EQ(a.report.lines[i].text, b.report.lines[i].text);
  ASSERT_TRUE(a.stages && b.stages);
  EXPECT_EQ(a.stages->done, b.stages->done);
  EXPECT_EQ(a.stages->file_lines.size(), b.stages->file_lines.size());
  expect_same(*a.stages->mesh, *b.stages->mesh);
}

inline void expect_same(SheetSettings a, SheetSettings b) {
  ASSERT_EQ(a.words.picture != nullptr, b.words.picture != nullptr);
  if (a.words.picture) {
    EXPECT_EQ(a.words.picture->width, b.words.picture->width);
    EXPECT_EQ(a.words.picture->rgba, b.words.picture->rgba);
  }
  a.words.picture = b.words.picture = nullptr;
  EXPECT_EQ(a, b);
}

/// Everything in them is equal, though no part need be the same object.
inline void expect_same(const Project& a, const Project& b) {
  EXPECT_EQ(a.path, b.path);
  expect_same(*a.source, *b.source);
  EXPECT_EQ(a.recipe, b.recipe);
  expect_same(*a.made, *b.made);
  ASSERT_EQ(a.tree != nullptr, b.tree != nullptr);
  if (a.tree) {
    EXPECT_EQ(*a.tree, *b.tree);
  }
  EXPECT_EQ(a.run, b.run);
  EXPECT_EQ(a.pins, b.pins);
  EXPECT_EQ(a.edits, b.edits);
  EXPECT_EQ(a.seed, b.seed);
  EXPECT_EQ(a.paper, b.paper);
  EXPECT_EQ(a.size, b.size);
  EXPECT_EQ(a.tabs, b.tabs);
  EXPECT_EQ(a.exports, b.exports);
  EXPECT_EQ(a.glued, b.glued);
  expect_same(a.sheet, b.sheet);
  EXPECT_EQ(a.placed, b.placed);
}

}  // namespace netwright::testing
