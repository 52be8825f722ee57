/// Advice whose texts cannot act in Markdown.
#pragma once

#include "parapet/reports/recommendation.hpp"

namespace parapet::reports {

/// The advice with every text that a spec or a study folder brought in escaped: names, reasons and
/// the like by markdown_text, formulas by code_text. What the text sections write of it is then
/// shown as it is written.
Recommendation safe_for_markdown(Recommendation advice);

}  // namespace parapet::reports
