// One texture per run; a run never changes, so nothing is ever sent twice.
#include "ui/run_pictures.h"

#include <cstdint>

namespace netwright {

ImTextureID RunPictures::of(const RunList::Entry& run) {
  Kept& kept = kept_[run.get()];
  if (kept.run.lock() != run) {
    kept.run = run;
    kept.texture.upload(run->picture);
  }
  return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(kept.texture.name()));
}

void RunPictures::tidy() {
  std::erase_if(kept_, [](const auto& entry) { return entry.second.run.expired(); });
}

}  // namespace netwright
