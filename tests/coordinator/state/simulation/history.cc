#include "tests/coordinator/state/simulation/history.h"

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "tests/coordinator/state/simulation/worker.h"

namespace tilemend::simulation {
namespace {

constexpr absl::Duration kFaulty = absl::Seconds(12);
constexpr absl::Duration kLimit = absl::Minutes(10);  // for what is left then

// A client that submits its job until it is answered, and asks until it is over.
class Client {
 public:
  Client(World& world, Coordinator& coordinator, std::string name, std::vector<std::string>& broken)
      : world_(world), coordinator_(coordinator), name_(std::move(name)), broken_(broken) {}

  void Submit() {
    if (is_known_) return;
    world_.Send(false, [this] { coordinator_.OnSubmit(name_, [this] { world_.Send(false, [this] { OnKnown(); }); }); });
    world_.After(absl::Seconds(2), [this] { Submit(); });
  }
  void Cancel() {
    was_cancelled_ = true;
    coordinator_.OnCancel(name_);
  }
  bool is_known() const { return is_known_; }
  bool is_over() const { return IsOver(told_.state); }
  const Told& told() const { return told_; }
  const std::string& name() const { return name_; }
  bool was_cancelled() const { return was_cancelled_; }

 private:
  void OnKnown() {
    if (std::exchange(is_known_, true)) return;
    Ask();
  }
  void Ask() {
    coordinator_.OnGet(name_, [this](const Told& told) {
      if (is_over() && (told.state != told_.state || told.outcome != told_.outcome)) {
        broken_.push_back("a job that was over became another");
      }
      told_ = told;
    });
    if (++asked_ < 2000) world_.After(absl::Milliseconds(is_over() ? 3000 : 700), [this] { Ask(); });
  }

  World& world_;
  Coordinator& coordinator_;
  const std::string name_;
  std::vector<std::string>& broken_;
  bool is_known_ = false, was_cancelled_ = false;
  int asked_ = 0;
  Told told_;
};

class History {
 public:
  History(uint64_t seed, const Faults& faults)
      : has_liar_(faults.liar || faults.swindler),
        has_swindler_(faults.swindler),
        world_(seed, faults),
        coordinator_(world_, store_, result_.broken) {
    const auto kind = [](bool is_so, Worker::Kind bad) { return is_so ? bad : Worker::Kind::kGood; };
    const Worker::Kind kinds[] = {faults.swindler ? Worker::Kind::kSwindler : kind(faults.liar, Worker::Kind::kLiar),
                                  kind(faults.full_disk, Worker::Kind::kFullDisk),
                                  kind(faults.slow, Worker::Kind::kSlow), Worker::Kind::kGood};
    for (const Worker::Kind k : kinds) {
      workers_.push_back(std::make_unique<Worker>(world_, coordinator_, absl::StrCat("w", workers_.size()), k,
                                                  1 + world_.random.Draw(3)));
    }
    for (int i = world_.random.Draw(3); i >= 0; --i) {
      const std::string name = absl::StrCat("j", i, std::string(1, static_cast<char>('a' + world_.random.Draw(12))));
      clients_.push_back(std::make_unique<Client>(world_, coordinator_, name, result_.broken));
    }
  }

  HistoryResult Run() {
    const bool has_killer = world_.faults.killer, has_poison = world_.faults.poison;
    coordinator_.Boot();
    for (const auto& worker : workers_) world_.After(world_.random.Time(0, 2000), [&w = *worker] { w.Boot(); });
    for (const auto& client : clients_) world_.After(world_.random.Time(0, 3000), [&c = *client] { c.Submit(); });
    if (world_.faults.cancel) world_.After(world_.random.Time(0, 5000), [this] { clients_.front()->Cancel(); });
    const absl::Time start = world_.now();
    world_.After(absl::Seconds(1), [this] { Disturb(); });
    RunUntil(start + kFaulty, false);
    world_.faults = {};
    world_.faults.killer = has_killer;  // these are in the data
    world_.faults.poison = has_poison;
    for (const auto& worker : workers_) worker->Heal();
    RunUntil(start + kFaulty + kLimit, true);
    Judge();
    return std::move(result_);
  }

 private:
  void RunUntil(absl::Time end, bool is_calm) {
    while (world_.now() < end && result_.broken.empty()) {
      if (!world_.Step()) break;
      if (is_calm && std::all_of(clients_.begin(), clients_.end(), [](const auto& c) { return c->is_over(); })) return;
    }
  }

  void Disturb() {
    const Faults& f = world_.faults;
    Random& random = world_.random;
    if (random.Chance(f.crash)) coordinator_.Crash();
    if (random.Chance(f.pause)) coordinator_.Pause(random.Time(500, 20'000));
    for (const auto& worker : workers_) {
      if (random.Chance(f.death)) worker->Die();
      if (random.Chance(f.freeze)) worker->Freeze(random.Time(500, 15'000));
      if (f.drain && random.Chance(10)) worker->Drain();
      if (random.Chance(f.partition)) {
        const int way = random.Draw(3);
        worker->Cut(way != 0, way != 1, random.Time(500, 12'000));
      }
    }
    world_.After(absl::Seconds(1), [this] { Disturb(); });
  }

  void Judge() {
    std::vector<std::string>& broken = result_.broken;
    result_.tally = coordinator_.tally();
    result_.set_aside = coordinator_.ever_set_aside();
    for (const std::string& worker : result_.set_aside) {
      if (!has_liar_ || !absl::StartsWith(worker, "w0.")) broken.push_back(worker + " was set aside, but is honest");
    }
    coordinator_.CheckEnd();
    if (store_.committed_twice() > 0) broken.push_back("a task was committed twice");
    if (store_.revived() > 0) broken.push_back("a job that was over went on");
    for (const auto& client : clients_) {
      ++result_.jobs;
      if (!client->is_over()) broken.push_back(absl::StrCat("job ", client->name(), " does not end"));
      const Told& told = client->told();
      result_.done += told.state == JobState::kDone;
      result_.partial += told.state == JobState::kPartial;
      result_.cancelled += told.state == JobState::kCancelled;
      result_.failed += told.state == JobState::kFailed;
      if (told.state == JobState::kFailed && !has_swindler_) broken.push_back("a job failed, and nobody is at fault");
      const bool is_right = told.outcome == Pipeline::Undisturbed(client->name());
      if (told.state == JobState::kDone && !is_right) broken.push_back("a job is done with another outcome");
      if (told.state == JobState::kPartial && is_right) broken.push_back("a job is partial, but nothing is missing");
      if (told.state == JobState::kCancelled && !client->was_cancelled()) broken.push_back("nobody cancelled the job");
    }
  }

  HistoryResult result_;
  const bool has_liar_, has_swindler_;
  World world_;
  Store store_;
  Coordinator coordinator_;
  std::vector<std::unique_ptr<Worker>> workers_;
  std::vector<std::unique_ptr<Client>> clients_;
};

}  // namespace

Faults FaultsOf(uint64_t seed) {
  Random random(seed ^ 0x5eed);
  const auto some = [&random](int most) { return random.Chance(50) ? 0 : random.Draw(most) + 1; };
  Faults faults;
  faults.loss = some(20);
  faults.doubling = some(20);
  faults.delay = some(20);
  faults.partition = some(15);
  faults.death = some(15);
  faults.freeze = some(15);
  faults.crash = some(20);
  faults.pause = some(10);
  faults.failing_store = some(5);
  faults.trouble = some(20);
  faults.liar = random.Chance(20);
  faults.full_disk = random.Chance(20);
  faults.slow = random.Chance(30);
  faults.killer = random.Chance(20);
  faults.cancel = random.Chance(15);
  faults.drain = random.Chance(20);
  faults.poison = random.Chance(20);
  faults.prefetch = random.Chance(70);
  faults.swindler = random.Chance(20);
  return faults;
}

HistoryResult RunHistory(uint64_t seed, const Faults& faults) { return History(seed, faults).Run(); }

}  // namespace tilemend::simulation
