#pragma once

#include "cook/order/choose_order.h"
#include "cook/recipe/cook_settings.h"
#include "cook/recipe/findings.h"
#include "platform/stop.h"

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace coif::cook {

struct PassTime {
  std::string name;  ///< Each name occurs once.
  double ms = 0;
};

/// The findings of the passes, and figures of their results.
struct CookReport : Findings {
  std::vector<PassTime> passes;
  std::uint32_t triangles = 0;
  std::uint32_t vertices = 0;
  std::uint32_t patches = 0;
  std::uint32_t patches_by_index = 0;
  std::uint32_t patches_by_position = 0;
  std::uint32_t chains = 0;
  std::uint32_t bones = 0;
  std::uint32_t simulated_bones = 0;
  OrderFigures order;
};

/// Receives the progress, the times and the findings of all stages of a cook.
class CookLog {
 public:
  CookLog(const CookSettings& settings, CookReport& report) : settings_(settings), report_(report) {}

  /// Calls `pass` and returns its result. Throws Stopped instead where settings.threads.stop is requested.
  auto pass(const char* name, const auto& pass) {
    const Timer timer(*this, name);
    return pass();
  }

  [[nodiscard]] Findings& findings() { return report_; }
  [[nodiscard]] CookReport& report() { return report_; }

 private:
  /// Reports the beginning and the end of a pass.
  class Timer {
   public:
    Timer(CookLog& log, const char* name) : log_(log), name_(name) {
      platform::throw_if_stopped(log.settings_.threads.stop);
      if (log.settings_.progress) log.settings_.progress(name);
    }
    ~Timer() {
      const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start_;
      log_.report_.passes.push_back({name_, elapsed.count()});
    }
    Timer(const Timer&) = delete;
    Timer& operator=(const Timer&) = delete;

   private:
    CookLog& log_;
    const char* name_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  };

  const CookSettings& settings_;
  CookReport& report_;
};

}  // namespace coif::cook
