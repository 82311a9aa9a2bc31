#include "app/compare/sweep.h"

#include "app/compare/content.h"
#include "app/compare/kept.h"
#include "app/compare/process.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

namespace firstlight::app::compare {
namespace {

namespace fs = std::filesystem;

constexpr int kFormat = 1;  // of what is kept; another one is not understood

/// Where the scenes' own files are looked for besides, by the switches that say so.
std::vector<fs::path> libraries_of(const CompareSettings& settings) {
  std::vector<fs::path> folders;
  for (const std::string& word : settings.words) {
    if (word.size() > 2 && (word.starts_with("+L") || word.starts_with("+l") || word.starts_with("-L"))) {
      folders.emplace_back(word.substr(2));
    }
  }
  return folders;
}

void add(Digest& digest, const std::vector<std::string>& words) {
  digest.add(static_cast<std::int64_t>(words.size()));
  for (const std::string& word : words) digest.add(word);
}

std::string optional_text(const std::optional<double>& value) { return value ? fmt::format("{}", *value) : "-"; }

class Sweep {
 public:
  explicit Sweep(const SweepPlan& plan)
      : plan_(plan), kept_(plan.cache), content_(libraries_of(plan.settings)), done_(plan.scenes.size()) {
    povray_ = content_.of_file(find_program(plan.settings.povray).value_or(fs::path()));
    const fs::path own =
        plan.settings.firstlight.empty() ? fs::read_symlink("/proc/self/exe") : plan.settings.firstlight;
    firstlight_ = content_.of_file(own);
  }

  SweepResult run() {
    result_.error = kept_.prepare();
    if (!result_.error.empty()) return std::move(result_);
    const auto jobs = std::clamp<std::size_t>(static_cast<std::size_t>(std::max(1, plan_.jobs)), 1, done_.size() + 1);
    std::vector<std::thread> others;
    for (std::size_t i = 1; i < jobs; ++i) others.emplace_back([this] { work(); });
    work();
    for (std::thread& other : others) other.join();
    for (std::optional<SceneRecord>& record : done_) {
      if (record) result_.records.push_back(std::move(*record));
    }
    result_.stopped = stopped();
    return std::move(result_);
  }

 private:
  struct Keys {
    std::string povray;
    std::string record;
  };

  bool stopped() const { return plan_.settings.stop != nullptr && *plan_.settings.stop; }

  void work() {
    for (std::size_t i = next_++; i < done_.size() && !stopped() && !failed_; i = next_++) {
      {
        const std::lock_guard lock(mutex_);
        if (plan_.begins) plan_.begins(plan_.scenes[i].name);
      }
      std::optional<SceneRecord> record;
      std::string error;
      const bool kept = take(plan_.scenes[i], record, error);
      const std::lock_guard lock(mutex_);
      if (!error.empty() && result_.error.empty()) result_.error = error;
      if (!error.empty()) failed_ = true;
      if (!record) continue;
      result_.kept += kept ? 1 : 0;
      if (plan_.ends) plan_.ends(*record, kept);
      done_[i] = std::move(record);
    }
  }

  CompareSettings settings_of(const ListedScene& scene) const {
    CompareSettings settings = plan_.settings;
    settings.words.insert(settings.words.end(), scene.words.begin(), scene.words.end());
    if (plan_.own_thresholds && (scene.share || scene.psnr)) {
      settings.thresholds.share = scene.share;
      settings.thresholds.psnr = scene.psnr;
    }
    return settings;
  }

  Keys keys_of(const ListedScene& scene, const CompareSettings& settings) {
    Digest digest;
    digest.add(kFormat).add(content_.of(scene.scene)).add(scene.scene.filename().string());
    digest.add(scene.ini ? scene.ini->filename().string() : "");
    digest.add(settings.width).add(settings.height).add(settings.threads).add(settings.rounds);
    digest.add(settings.time_limit.count());
    add(digest, settings.words);
    digest.add(povray_);
    Keys keys{digest.text(), {}};
    digest.add(firstlight_).add(plan_.povray_too ? "both" : "");
    digest.add(optional_text(settings.thresholds.share)).add(optional_text(settings.thresholds.psnr));
    digest.add(fmt::format("{}", settings.thresholds.psnr_8x8));
    add(digest, settings.our_words);
    keys.record = digest.text();
    return keys;
  }

  /// Whether the record was kept. No record when it was stopped meanwhile, or when `error` says what is wrong.
  bool take(const ListedScene& scene, std::optional<SceneRecord>& record, std::string& error) {
    const CompareSettings settings = settings_of(scene);
    const Keys keys = keys_of(scene, settings);
    if (!plan_.again) record = kept_.record(keys.record);
    const bool kept = record.has_value();
    if (!kept) {
      SceneRecord fresh = compare(scene, settings, keys, error);
      if (stopped() || !error.empty()) return false;
      record = std::move(fresh);
    }
    // The same scene may lie elsewhere, too.
    record->name = scene.name;
    record->scene = scene.scene;
    return kept;
  }

  SceneRecord compare(const ListedScene& scene, const CompareSettings& settings, const Keys& keys, std::string& error) {
    const std::optional<Rendered> povray = kept_.povray(keys.povray);
    SceneJob job;
    job.scene = scene.scene;
    job.ini = scene.ini;
    job.name = scene.name;
    job.povray = povray ? &*povray : nullptr;
    SceneRecord record;
    fs::path scratch;
    if (!povray && !plan_.povray_too) record.missing = plan_.missing(job, settings);
    if (!record.missing.empty()) {
      record.status = Status::lacks_features;
    } else if (!stopped()) {
      error = kept_.make_scratch(scratch);
      job.pictures = scratch;
      if (error.empty()) record = plan_.compare(job, settings);
      if (error.empty()) error = record.keeping;
    }
    if (error.empty() && !stopped()) {
      const Rendered theirs{record.povray, record.povray_picture, record.povray_message, {}};
      const bool has_rendered = !theirs.picture.empty() || !theirs.error.empty();
      if (!povray && has_rendered) error = kept_.keep_povray(keys.povray, theirs);
      if (error.empty()) error = kept_.keep_record(keys.record, record);
    }
    std::error_code ignored;
    if (!scratch.empty()) fs::remove_all(scratch, ignored);
    return record;
  }

  const SweepPlan& plan_;
  const KeptResults kept_;
  SceneContent content_;
  std::string povray_;  // what the programs are
  std::string firstlight_;
  std::vector<std::optional<SceneRecord>> done_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> failed_ = false;
  std::mutex mutex_;  // of result_ and of what is told
  SweepResult result_;
};

}  // namespace

SweepResult sweep(const SweepPlan& plan) { return Sweep(plan).run(); }

}  // namespace firstlight::app::compare
