#include "accel/kdtree/builder/subtree.h"

#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>

namespace ropelight {
namespace {

void gather(const KdSubtree& from, KdPart& to) {
  to.addReferences(from.part);
  for (const auto& half : from.half)
    if (half) gather(*half, to);
}

void place(std::unique_ptr<KdSubtree> subtree, KdTree& tree, const KdPart::Mark& at) {
  if (!subtree->half[0]) return subtree->part.copyTo(tree, at);
  KdPart::Mark const low{at.nodes + 1, at.leaves, at.references}, high = low + subtree->half[0]->size;
  tree.nodes[at.nodes].split = subtree->plane.position;
  tree.nodes[at.nodes].link = std::uint32_t(high.nodes) << 2 | std::uint32_t(subtree->plane.axis);
  oneapi::tbb::parallel_invoke([&] { place(std::move(subtree->half[0]), tree, low); },
                               [&] { place(std::move(subtree->half[1]), tree, high); });
}

}  // namespace

void KdPart::addLeaf(const std::vector<KdItem>& items) {
  nodes_.push_back({0, std::uint32_t(leafSizes_.size()) << 2 | 3u});
  leafSizes_.push_back(std::uint32_t(items.size()));
  for (const KdItem& item : items) references_.push_back(item.primitive);
}

std::size_t KdPart::addInner(const KdPlane& plane) {
  nodes_.push_back({plane.position, std::uint32_t(plane.axis)});
  return nodes_.size() - 1;
}

void KdPart::beginHigh(std::size_t node) { nodes_[node].link |= std::uint32_t(nodes_.size()) << 2; }

std::size_t KdPart::collapse(const Mark& from) {
  auto const first = references_.begin() + std::ptrdiff_t(from.references);
  std::sort(first, references_.end());
  references_.erase(std::unique(first, references_.end()), references_.end());
  nodes_.resize(from.nodes);
  leafSizes_.resize(from.leaves);
  nodes_.push_back({0, std::uint32_t(leafSizes_.size()) << 2 | 3u});
  leafSizes_.push_back(std::uint32_t(references_.size() - from.references));
  return leafSizes_.back();
}

void KdPart::addReferences(const KdPart& other) {
  references_.insert(references_.end(), other.references_.begin(), other.references_.end());
}

void KdPart::copyTo(KdTree& tree, const Mark& at) const {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    std::size_t const offset = nodes_[i].isLeaf() ? at.leaves : at.nodes;
    tree.nodes[at.nodes + i] = {nodes_[i].split, nodes_[i].link + (std::uint32_t(offset) << 2)};
  }
  std::size_t first = at.references;
  for (std::size_t i = 0; i < leafSizes_.size(); ++i) {
    tree.leaves[at.leaves + i].first = std::uint32_t(first);
    tree.leaves[at.leaves + i].count = leafSizes_[i];
    first += leafSizes_[i];
  }
  std::copy(references_.begin(), references_.end(), tree.references.begin() + std::ptrdiff_t(at.references));
}

std::size_t KdSubtree::collapse() {
  KdPart leaf;
  gather(*this, leaf);
  std::size_t const primitives = leaf.collapse({});
  part = std::move(leaf);
  half[0].reset();
  half[1].reset();
  size = part.end();
  return primitives;
}

void assemble(std::unique_ptr<KdSubtree> root, KdTree& tree) {
  tree.nodes.resize(root->size.nodes);
  tree.leaves.resize(root->size.leaves);
  tree.references.resize(root->size.references);
  place(std::move(root), tree, {});
}

}  // namespace ropelight
