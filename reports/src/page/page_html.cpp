#include "page_html.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <stdexcept>

#include "base64.hpp"
#include "embedded.hpp"
#include "key_text.hpp"
#include "parapet/math/units.hpp"
#include "parapet/records/checksum.hpp"
#include "parapet/records/provenance.hpp"
#include "parapet/solver/metric_catalog.hpp"

namespace parapet::reports {
namespace {

using designs::Json;

std::string_view embedded(std::string_view name) {
  for (const EmbeddedFile& file : embedded_files()) {
    if (file.name == name) return file.text;
  }
  throw std::logic_error("the program does not hold " + std::string(name));
}

std::string text_base64(std::string_view bytes) {
  return base64(std::as_bytes(std::span(bytes.data(), bytes.size())));
}

/// "sha256-...", by which a Content-Security-Policy knows a script or a style.
std::string source_hash(std::string_view text) {
  const std::string digits = records::sha256(text);
  std::string bytes;
  for (std::size_t k = 0; k < digits.size(); k += 2) {
    bytes += static_cast<char>(std::strtoul(digits.substr(k, 2).c_str(), nullptr, 16));
  }
  return "'sha256-" + text_base64(bytes) + "'";
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '&':
        out += "&amp;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

/// JSON that can stand inside a script element.
std::string script_json(const Json& json) {
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    if (c == '<') {
      out += "\\u003c";
    } else {
      out += c;
    }
  }
  return out;
}

/// SOURCE_DATE_EPOCH makes a page repeatable.
std::string date_text() {
  std::time_t now = std::time(nullptr);
  if (const char* given = std::getenv("SOURCE_DATE_EPOCH")) {
    now = static_cast<std::time_t>(std::strtoll(given, nullptr, 10));
  }
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
}

}  // namespace

PageBlock page_block(std::string id, std::string_view bytes) {
  return {.id = std::move(id), .base64 = text_base64(bytes)};
}

Json simulated_by(const Json& provenance) {
  if (!provenance.is_object() || !provenance.contains("program_version")) return nullptr;
  Json program{{"version", provenance.at("program_version")}};
  for (const char* key : {"git_revision", "compiler", "physics"}) {
    if (provenance.contains(key)) program[key] = provenance.at(key);
  }
  return program;
}

Json common_json(const std::string& kind, const std::string& name, const std::string& hash,
                 const PageOptions& options) {
  Json program{{"version", options.program.version},
               {"physics", options.program.physics},
               {"compiler", records::compiler_name()}};
  if (!options.program.git_revision.empty()) {
    program["git_revision"] = options.program.git_revision;
  }
  return {{"format", "parapet-page/1"},
          {"kind", kind},
          {"name", name},
          {"description", ""},
          {"date", date_text()},
          {"hash", hash},
          {"program", std::move(program)},
          {"keys", Json::object()},
          {"commands", Json::array()},
          {"runs", Json::object()},
          {"live", options.live}};
}

void add_key(Json& page, const std::string& key) {
  Json& keys = page["keys"];
  if (keys.contains(key)) return;
  Json info{{"words", key_words(key)}, {"unit", math::unit_of(key).typographic}};
  if (const auto metric = solver::find_metric_info(key)) info["definition"] = metric->definition;
  keys[key] = std::move(info);
}

void add_command(Json& page, const std::string& what, const std::string& command) {
  page["commands"].push_back({{"what", what}, {"command", command}});
}

std::string page_html(const Json& page, const std::vector<PageBlock>& blocks) {
  const std::string_view script = embedded("page.js"), style = embedded("page.css");
  const bool live = page.value("live", false);
  std::string html = fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src {}; "
      "style-src {}; img-src data:;{} base-uri 'none'; form-action 'none'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"referrer\" content=\"no-referrer\">\n<title>{} – Parapet</title>\n"
      "<style>",
      source_hash(script), source_hash(style), live ? " connect-src 'self';" : "",
      escaped(page.at("name").get<std::string>()));
  html += style;
  html +=
      "</style>\n</head>\n<body>\n<noscript>This page shows its numbers with JavaScript, which is "
      "switched off. The same numbers are in the files beside it.</noscript>\n"
      "<div id=\"page-blocks\" hidden>\n<script type=\"application/json\" id=\"page-data\">";
  html += script_json(page);
  html += "</script>\n";
  for (const PageBlock& block : blocks) {
    html += fmt::format("<script type=\"text/plain\" id=\"{}\">", escaped(block.id));
    html += block.base64;
    html += "</script>\n";
  }
  html +=
      "<div id=\"page-licences\">" + escaped(embedded("licences.txt")) + "</div>\n</div>\n<script>";
  html += script;
  html += "</script>\n</body>\n</html>\n";
  return html;
}

std::string shell_word(const std::string& text) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("_-./=,:+@%").find(c) != std::string_view::npos;
  };
  if (!text.empty() && std::ranges::all_of(text, plain)) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace parapet::reports
