// SPDX-License-Identifier: Apache-2.0
// Whether docs/sky_file.md has the table of sky/domain.h, or, with --write, puts it there.
//   domain_page PAGE [--write]
#include <string_view>

#include "sky/domain.h"
#include "tests/page.h"

int main(int count, char** arguments) {
  if (count < 2) {
    std::fputs("domain_page PAGE [--write]\n", stderr);
    return 1;
  }
  const bool write = count > 2 && std::string_view(arguments[2]) == "--write";
  return welkin::test::bringUpToDate(arguments[1], "domain", welkin::sky::domainTable(welkin::sky::domain()), write);
}
