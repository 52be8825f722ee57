/// Fontconfig keeps its patterns until the process ends; the leak sanitizer must not blame us.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libfontconfig\n";
}
