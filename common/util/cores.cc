#include "common/util/cores.h"

#include <utility>

namespace tilemend {
namespace {

// Of which this thread holds one.
thread_local Cores* held_of = nullptr;

}  // namespace

void Cores::Take() {
  std::unique_lock<std::mutex> lock(mutex_);
  freed_.wait(lock, [this] { return free_ > 0; });
  --free_;
}

void Cores::Give() {
  std::lock_guard<std::mutex> lock(mutex_);
  ++free_;
  freed_.notify_one();
}

Cores::Held::Held(Cores& cores) {
  cores.Take();
  held_of = &cores;
}

Cores::Held::~Held() { std::exchange(held_of, nullptr)->Give(); }

LentCore::LentCore() : cores_(std::exchange(held_of, nullptr)) {
  if (cores_ != nullptr) cores_->Give();
}

LentCore::~LentCore() {
  if (cores_ == nullptr) return;
  cores_->Take();
  held_of = cores_;
}

}  // namespace tilemend
