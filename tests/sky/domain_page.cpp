// SPDX-License-Identifier: Apache-2.0
// Whether docs/sky_file.md has the table of sky/bake/sky_domain.h. With --write it puts the table there.
//   domain_page PAGE [--write]
#include <string_view>

#include "sky/bake/sky_domain.h"
#include "tests/page.h"

int main(int count, char** arguments) {
  if (count < 2) {
    std::fputs("domain_page PAGE [--write]\n", stderr);
    return 1;
  }
  const bool write = count > 2 && std::string_view(arguments[2]) == "--write";
  return welkin::tests::bringUpToDate(arguments[1], "domain", welkin::base::domainTable(welkin::bake::skyDomain()),
                                      write);
}
