#!/bin/sh
# Builds the page of `coif view` from its sources and puts it into the source tree, so that a build of the program needs
# no Emscripten:
#   tools/view/built/view.html         the page, which `coif view` fills in and `cmake --install` installs
#   tools/view/built/sources.sha256    the digest of each file that the page was built from, as sha256sum prints it
# Beside them, tools/view/built/emscripten has the licences of Emscripten and its C library, parts of which are in the page.
# Run it after a change of any of those files; the guard built_page says when. Debian 12's Emscripten gives the same bytes
# in any folder of any machine.
set -eu
cd "$(dirname "$0")/../.."
sh tools/install_packages.sh program web
cmake --preset web -DCOIF_TESTS=OFF >/dev/null
cmake --build build/web --parallel "$(nproc)" --target coif_view_html

# Sources by ninja's graph, headers by what the compiler read. Files of packages and of the build tree are left out.
objects=$(ninja -C build/web -t inputs view/view.html | grep '\.o$')
{
  ninja -C build/web -t inputs view/view.html | grep -v '^ninja: '
  # shellcheck disable=SC2086  # a list: it must fall apart into words
  ninja -C build/web -t deps $objects | sed -n 's/^    //p'
  echo "$PWD/tools/view/page/CMakeLists.txt"
} | grep "^$PWD/" | grep -v "^$PWD/build/" | sed "s|^$PWD/||" | LC_ALL=C sort -u | xargs sha256sum >build/web/view/sources.sha256

cp build/web/view/view.html build/web/view/sources.sha256 tools/view/built/
echo "tools/view/built/view.html: $(wc -c <tools/view/built/view.html) bytes, from $(wc -l <tools/view/built/sources.sha256) files"
