#!/usr/bin/env bash
# Renders a POV-Ray scene: ./render.sh SCENE.pov [options of build/release/firstlight, such as +W640 +H480]
# Installs what is missing (Debian packages), builds what changed, renders, and says where the picture is.
set -euo pipefail

if [ $# -eq 0 ] || [ "$1" = -h ] || [ "$1" = --help ]; then
  echo "usage: ./render.sh SCENE.pov [+W640 +H480 +Opicture.png --threads N --scheme NAME ...]"
  exit $(($# == 0))
fi
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
called_from=$PWD
cd "$root"
. .ci/setup.sh

# Without +O the picture is named after the scene and goes to build/pictures, so that nothing is littered.
scene="" picture=""
for argument in "$@"; do
  case $argument in
    [+-]O?*) picture=${argument:2} ;;
    [+-]I?*) scene=${argument:2} ;;
    [+-]*) ;;
    *.pov) scene=$argument ;;
  esac
done
options=()
if [ -z "$picture" ]; then
  mkdir -p build/pictures
  name=$(basename "${scene:-picture}")
  picture=$root/build/pictures/${name%.*}.png
  options+=("+O$picture")
fi

install_missing $build_packages $render_packages
build release firstlight_program
cd "$called_from"
say "Rendering ${scene:-$*}"
"$root/build/release/firstlight" "$@" "${options[@]}"
[ -f "$picture" ] || exit 0  # a name the program completed itself, which it has printed
say "The picture is $picture"

# Shows it where the terminal itself can draw pictures, or where chafa is installed.
if [ -t 1 ]; then
  case "${TERM:-}/${TERM_PROGRAM:-}" in
    xterm-kitty/* | xterm-ghostty/*)
      base64 -w 4096 "$picture" | {
        control="a=T,f=100,"
        while IFS= read -r chunk; do
          printf '\033_G%sm=1;%s\033\\' "$control" "$chunk"
          control=""
        done
        printf '\033_Gm=0;\033\\\n'
      }
      ;;
    */iTerm.app | */WezTerm) printf '\033]1337;File=inline=1:%s\a\n' "$(base64 -w 0 "$picture")" ;;
    *) if command -v chafa >/dev/null; then chafa --size 72x36 "$picture"; fi ;;
  esac
fi
