#include "coordinator/jobs/worker_trust.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

constexpr absl::Duration kLookAgain = absl::Seconds(30);
constexpr absl::Duration kLongLook = absl::Seconds(5);  // a look takes milliseconds, over a slow network a second
constexpr size_t kMostSetAside = 10'000;
constexpr size_t kMostStrangerErrorBytes = 500;  // of a stranger's text

// What is wrong with a look, "" if nothing is.
std::string FaultOf(const JobFolders& folders, const v1::FoldersSeen& seen) {
  if (seen.files_size() != static_cast<int>(folders.files.size())) return "it did not look";
  for (size_t i = 0; i < folders.files.size(); ++i) {
    const v1::FileSeen& file = seen.files(static_cast<int>(i));
    if (!file.error().empty()) return Printable(file.error().substr(0, kMostStrangerErrorBytes));
    if (file.fingerprint() != folders.files[i].fingerprint) {
      return absl::StrCat(Printable(folders.files[i].path), ": another file there");
    }
  }
  return seen.write_error().empty() ? "" : Printable(seen.write_error().substr(0, kMostStrangerErrorBytes));
}

}  // namespace

void WorkerTrust::JobView::See(const std::string& worker, absl::Time look_again) {
  Forget(worker);
  seen_by[worker] = look_again;
  if (look_again != absl::InfiniteFuture()) ++blind;
}

void WorkerTrust::JobView::Forget(const std::string& worker) {
  const auto seen = seen_by.find(worker);
  if (seen == seen_by.end()) return;
  if (seen->second != absl::InfiniteFuture()) --blind;
  seen_by.erase(seen);
}

void WorkerTrust::AddJob(const std::string& job, JobFolders folders) {
  if (!folders.files.empty() || !folders.attempts.empty()) jobs_[job].folders = std::move(folders);
}

const JobFolders* WorkerTrust::FoldersOf(const std::string& job) const {
  const auto view = jobs_.find(job);
  return view == jobs_.end() ? nullptr : &view->second.folders;
}

std::vector<v1::JobFolders> WorkerTrust::ToLookAt(const std::string& worker, const std::set<std::string>& busy,
                                                  absl::Time now) const {
  std::vector<v1::JobFolders> look;
  if (set_aside_.contains(worker)) return look;
  for (const auto& [job, view] : jobs_) {
    const auto seen = view.seen_by.find(worker);
    if (busy.contains(job) || (seen != view.seen_by.end() && seen->second > now)) continue;
    v1::JobFolders& folders = look.emplace_back();
    folders.set_job(job);
    for (const KnownFile& file : view.folders.files) folders.add_files(file.path);
    folders.set_attempts(view.folders.attempts);
  }
  return look;
}

std::optional<std::string> WorkerTrust::TakeSeen(const std::string& worker, const v1::FoldersSeen& seen,
                                                 absl::Time now) {
  const auto view = jobs_.find(seen.job());
  if (view == jobs_.end()) return std::nullopt;
  if (seen.looking()) {
    view->second.looks_since.try_emplace(worker, now);
    return std::nullopt;
  }
  view->second.looks_since.erase(worker);
  const std::string fault = FaultOf(view->second.folders, seen);
  view->second.See(worker, fault.empty() ? absl::InfiniteFuture() : now + kLookAgain);
  if (fault.empty()) return std::nullopt;
  return absl::StrCat("worker ", Printable(worker),
                      " gets no task: it does not see the job's folders as the coordinator does: ", fault);
}

void WorkerTrust::Doubt(const std::string& worker, const std::string& job) {
  if (const auto view = jobs_.find(job); view != jobs_.end()) view->second.Forget(worker);
}

void WorkerTrust::RemoveWorker(const std::string& worker) {
  for (auto& [job, view] : jobs_) {
    view.Forget(worker);
    view.looks_since.erase(worker);
  }
}

void WorkerTrust::Put(const std::string& worker, Aside aside) {
  if (set_aside_.size() >= kMostSetAside) set_aside_.erase(set_aside_.begin());
  set_aside_[worker] = std::move(aside);
}

bool WorkerTrust::Clear(const std::string& worker) {
  const auto aside = set_aside_.find(worker);
  if (aside == set_aside_.end() || aside->second.is_for_good) return false;
  set_aside_.erase(aside);
  return true;
}

std::string WorkerTrust::WhySetAside(const std::string& worker) const {
  const auto reason = set_aside_.find(worker);
  return reason == set_aside_.end() ? "" : reason->second.reason;
}

bool WorkerTrust::IsSetAside(const std::string& worker) const {
  const auto aside = set_aside_.find(worker);
  return aside != set_aside_.end() && aside->second.is_for_good;
}

bool WorkerTrust::MayWorkOn(const std::string& worker, const std::string& job) const {
  if (set_aside_.contains(worker)) return false;
  const auto view = jobs_.find(job);
  if (view == jobs_.end()) return true;
  const auto seen = view->second.seen_by.find(worker);
  return seen != view->second.seen_by.end() && seen->second == absl::InfiniteFuture();
}

bool WorkerTrust::IsBarred(const std::string& worker, const std::string& job) const {
  if (set_aside_.contains(worker)) return true;
  const auto view = jobs_.find(job);
  return view != jobs_.end() && view->second.seen_by.contains(worker) && !MayWorkOn(worker, job);
}

bool WorkerTrust::SeemsStuck(const std::string& worker, const std::string& job, absl::Time now) const {
  const auto view = jobs_.find(job);
  if (view == jobs_.end()) return false;
  const auto since = view->second.looks_since.find(worker);
  return since != view->second.looks_since.end() && now - since->second > kLongLook;
}

std::vector<std::string> WorkerTrust::BlindTo(const std::string& worker) const {
  std::vector<std::string> jobs;
  for (const auto& [job, view] : jobs_) {
    const auto seen = view.seen_by.find(worker);
    if (seen != view.seen_by.end() && seen->second != absl::InfiniteFuture()) jobs.push_back(job);
  }
  return jobs;
}

WorkerTrust::Counts WorkerTrust::Count() const {
  Counts counts{set_aside_.size(), 0};
  for (const auto& [job, view] : jobs_) counts.blind += view.blind;
  return counts;
}

}  // namespace tilemend
