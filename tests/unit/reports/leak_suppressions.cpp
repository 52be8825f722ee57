/// Fontconfig keeps its patterns until the process ends; the leak sanitizer must not blame us.
// NOLINTNEXTLINE(bugprone-reserved-identifier): the sanitizer's name
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libfontconfig\n";
}
