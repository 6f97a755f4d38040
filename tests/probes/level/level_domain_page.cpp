// SPDX-License-Identifier: Apache-2.0
// Checks that docs/level_file.md has the table of probes/level/level_domain.h, or with --write puts it there.
//   level_domain_page PAGE [--write]
#include <string_view>

#include "probes/level/level_domain.h"
#include "tests/page.h"

int main(int count, char** arguments) {
  if (count < 2) {
    std::fputs("level_domain_page PAGE [--write]\n", stderr);
    return 1;
  }
  const bool write = count > 2 && std::string_view(arguments[2]) == "--write";
  return welkin::tests::bringUpToDate(arguments[1], "domain", welkin::base::domainTable(welkin::level::levelDomain()),
                                      write);
}
