#include <limits>

#include "study_parts.hpp"

namespace parapet::designs {
namespace {

constexpr double least_kept_share = 1e-6;  // of a truncated distribution

/// Reads a distribution, which takes some keys and no others.
class DistributionReader {
 public:
  DistributionReader(const Json& json, const std::string& pointer, Findings& findings)
      : json_(json), pointer_(pointer), findings_(findings), before_(findings.size()) {}

  /// Nothing, with findings, when it is not sound.
  std::optional<Distribution> read() {
    const std::string kind = json_.at("distribution").get<std::string>();
    Distribution result;
    if (kind == "normal" || kind == "lognormal") {
      result.kind = kind == "normal" ? DistributionKind::normal : DistributionKind::lognormal;
      read_moments(result);
    } else {
      result.kind = kind == "uniform" ? DistributionKind::uniform : DistributionKind::triangular;
      read_range(result);
    }
    return sound() ? std::optional(result) : std::nullopt;
  }

 private:
  bool sound() const { return findings_.size() == before_; }

  double need(const char* key) {
    if (json_.contains(key)) return json_.at(key).get<double>();
    findings_.add(child_pointer(pointer_, key), "is missing", "a number, for this distribution");
    return 0.0;
  }

  void refuse(const char* key) {
    if (!json_.contains(key)) return;
    findings_.add(child_pointer(pointer_, key), "has no use in this distribution",
                  "mean and sd, lower and upper for normal and lognormal; lower and upper for "
                  "uniform, with mode for triangular");
  }

  void read_moments(Distribution& result) {
    refuse("mode");
    result.mean = need("mean");
    result.sd = need("sd");
    const bool positive = result.kind == DistributionKind::lognormal;
    if (sound() && positive && result.mean <= 0.0) {
      findings_.add(pointer_ + "/mean", "is too small", "a number above 0, for a lognormal one");
    }
    constexpr double infinity = std::numeric_limits<double>::infinity();
    result.lower = json_.value("lower", positive ? 0.0 : -infinity);
    result.upper = json_.value("upper", infinity);
    check_order(result);
    if (sound() && kept_share(result) < least_kept_share) {
      findings_.add(pointer_, "has next to nothing between its lower and upper value",
                    "a range that holds at least a share of " + rounded(least_kept_share));
    }
  }

  void read_range(Distribution& result) {
    refuse("mean");
    refuse("sd");
    result.lower = need("lower");
    result.upper = need("upper");
    if (result.kind == DistributionKind::uniform) {
      refuse("mode");
    } else {
      result.mode = need("mode");
    }
    check_order(result);
    if (sound() && result.kind == DistributionKind::triangular &&
        (result.mode < result.lower || result.mode > result.upper)) {
      findings_.add(pointer_ + "/mode", "is not between the lower and the upper value",
                    "lower <= mode <= upper");
    }
  }

  void check_order(const Distribution& result) {
    if (!sound() || result.lower < result.upper) return;
    findings_.add(pointer_, "the lower value is not below the upper", "lower < upper");
  }

  const Json& json_;
  std::string pointer_;
  Findings& findings_;
  std::size_t before_;
};

}  // namespace

std::optional<Distribution> read_distribution(const Json& json, const std::string& pointer,
                                              Findings& findings) {
  return DistributionReader(json, pointer, findings).read();
}

}  // namespace parapet::designs
