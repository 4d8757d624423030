#include "common/http/held_connections.h"

#include <utility>

namespace tilemend {

HeldConnections::HeldConnections(size_t most, std::function<void(std::shared_ptr<TimedConnection>)> leave)
    : most_(most), leave_(std::move(leave)), thread_([this] { Run(); }) {}

HeldConnections::~HeldConnections() { Close(); }

void HeldConnections::Shared::Wake(uint64_t number) {
  const auto found = held.find(number);
  if (found == held.end()) return;
  woken.push_back(std::move(found->second));
  held.erase(found);
  changed.notify_all();
}

void HeldConnections::Hold(std::shared_ptr<TimedConnection> connection, const Wait& wait) {
  uint64_t number = 0;
  {
    const std::lock_guard<std::mutex> lock(shared_->mutex);
    if (shared_->closed || shared_->woken.size() >= most_) return;
    if (shared_->held.size() >= most_) {
      shared_->held.begin()->second.connection->MakeRoom();
      shared_->Wake(shared_->held.begin()->first);
    }
    number = ++shared_->last;
    shared_->held[number].connection = std::move(connection);
  }
  std::shared_ptr<void> waits = wait([weak = std::weak_ptr(shared_), number] {
    const auto shared = weak.lock();
    if (shared == nullptr) return;
    const std::lock_guard<std::mutex> lock(shared->mutex);
    shared->Wake(number);
  });
  const std::lock_guard<std::mutex> lock(shared_->mutex);
  const auto found = shared_->held.find(number);
  if (found != shared_->held.end()) found->second.waits.swap(waits);
}

void HeldConnections::Close() {
  std::map<uint64_t, Guest> held;
  std::deque<Guest> woken;
  {
    const std::lock_guard<std::mutex> lock(shared_->mutex);
    shared_->closed = true;
    held.swap(shared_->held);
    woken.swap(shared_->woken);
    shared_->changed.notify_all();
  }
  if (thread_.joinable()) thread_.join();
}

void HeldConnections::Run() {
  std::unique_lock<std::mutex> lock(shared_->mutex);
  while (true) {
    shared_->changed.wait(lock, [&] { return shared_->closed || !shared_->woken.empty(); });
    if (shared_->closed) return;
    Guest guest = std::move(shared_->woken.front());
    shared_->woken.pop_front();
    lock.unlock();
    guest.waits.reset();
    leave_(std::move(guest.connection));
    lock.lock();
  }
}

}  // namespace tilemend
