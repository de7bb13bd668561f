#!/bin/sh
# shellcheck disable=SC2016  # the texts of stubs are for the stubs to expand
# front_door.sh: what ./dem does on machines that we do not have. A machine is a directory of
# programs that is the whole PATH; nothing is installed or built. Headers are the real machine's.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
copy="$dir/path with spaces"  # a copy, so that nothing of this lands in the real build/
mkdir -p "$copy/tinydem/scenes/box"
cp "$root/dem" "$copy"
echo '# grains in a box' > "$copy/tinydem/scenes/box/scene.ini"

for shell in dash bash; do
  if command -v "$shell" > /dev/null; then "$shell" -n "$root/dem"; fi
done

# expect CODE TEXT ARGUMENT...: ./dem ARGUMENT... ends with this code, and says (or logs) the text.
expect() {
  want=$1 text=$2 code=0
  shift 2
  : > "$dir/log"
  env -i PATH="$path" LOG="$dir/log" COPY="$copy" sh "$copy/dem" "$@" \
    > "$dir/out" 2>&1 < /dev/null || code=$?
  cat "$dir/log" >> "$dir/out"
  if [ "$code" -ne "$want" ] || ! grep -qF -e "$text" "$dir/out"; then
    echo "FAILED: ./dem $* should give exit code $want (got $code) and the text: $text"
    cat "$dir/out"
    exit 1
  fi
  echo "ok: $(basename "$path"): ./dem $*"
}
never() {
  if grep -F -e "$1" "$dir/out"; then echo "FAILED: unwanted text: $1"; exit 1; fi
}

# machine NAME: the basic tools.   stub NAME TEXT: adds a program to the machine made last.
machine() {
  path=$dir/$1
  mkdir "$path"
  for tool in basename cat chmod dirname env getconf grep mkdir readlink rm sed sh tr; do
    ln -s "$(command -v "$tool")" "$path/$tool"
  done
  stub id 'echo 1000'
}
stub() { printf '#!/bin/sh\n%s\n' "$2" > "$path/$1"; chmod +x "$path/$1"; }

cd /
machine bare
expect 0 'usage: ./dem VERB' help
expect 2 "no verb 'tset'" tset
expect 2 'grains in a box' run
expect 2 "no scene 'nosuch'" run nosuch
expect 2 'which run?' render /nosuch
expect 1 'apt-get install g++ cmake make' build
expect 1 'dnf install gcc-c++ cmake make' run box
expect 1 'brew install gcc cmake make' setup
expect 1 'conda install -c conda-forge gxx cmake make' test
expect 1 'apt-get install doxygen' docs
expect 2 'the only option is --update' docs --updat

machine no_root
stub apt-get 'echo "apt-get $*" >> "$LOG"'
expect 1 'apt-get install g++ cmake make' build
never 'apt-get update'

machine with_sudo  # only g++ is missing; the install works, the build then does not
stub dpkg-query 'for last; do :; done; [ "$last" = g++ ] || printf installed'
stub apt-get 'echo "apt-get $* [$DEBIAN_FRONTEND]" >> "$LOG"'
stub sudo '[ "$1" = -n ] || exec env DEBIAN_FRONTEND= "$@"'
stub cmake 'echo "compiler error"; exit 3'
expect 1 'install -y --no-install-recommends g++ [noninteractive]' build
expect 1 'apt-get update' build
expect 1 'compiler error' build
stub apt-get 'echo "E: no network"; exit 100'
expect 1 'E: no network' build
expect 1 'dnf install gcc-c++' build

machine complete
stub dpkg-query 'printf installed'
stub apt-get 'echo "apt-get $*" >> "$LOG"'
stub python3 'echo "python3 $*" >> "$LOG"'
stub ctest 'echo "ctest $*" >> "$LOG"; exit 8'
stub cmake 'echo "cmake $*" >> "$LOG"; mkdir -p "$COPY/build/default"; cd "$COPY/build/default"
cat > tinydem << "END"
#!/bin/sh
echo "tinydem $*" >> "$LOG"
while [ $# -gt 1 ]; do [ "$1" != --output ] || mkdir -p "$2"; shift; done
END
chmod +x tinydem'
expect 0 'cmake --preset default -DTINYDEM_BUILD_TESTS=OFF' build
never apt-get
expect 0 "tinydem --output $copy/output/box --scene $copy/tinydem/scenes/box/scene.ini" run box
expect 0 'scene.ini --overwrite --mus 0.1' run box --mus 0.1
expect 0 'scene.ini --overwrite --mesh my.off' run box --mesh my.off
expect 2 'a run is in output/SCENE' run box --output elsewhere
expect 2 './dem render DIR' run box --output=elsewhere
expect 0 'scene.ini --resume' run box --resume
never --overwrite
expect 0 'tinydem --help' run box --help
never python3
expect 2 'has no full.ini' run box --full
expect 2 "--seeds 'x'" run box --seeds x
expect 2 'how many?' run box --seeds
expect 0 "output/box-2 --scene $copy/tinydem/scenes/box/scene.ini --overwrite --seed 2 --mus 0.1" \
  run box --seeds 2 --mus 0.1
never "box-3"
echo '# more grains' > "$copy/tinydem/scenes/box/full.ini"
echo '# other grains' > "$copy/tinydem/scenes/box/other.ini"
echo 'print()' > "$copy/tinydem/scenes/box/measure.py"
expect 0 "output/box-full --scene $copy/tinydem/scenes/box/full.ini" run box --full
expect 0 "measure.py box box-other" run box --series
never full.ini
echo 'mesh = part.stl' >> "$copy/tinydem/scenes/box/scene.ini"
expect 0 "mesh_tools.py $copy/tinydem/scenes/box/part.stl $copy/output/box.off" run box
expect 0 "tinydem --mesh $copy/output/box.off --output $copy/output/box --scene" run box
expect 0 'render.py' run "$copy/tinydem/scenes/box/scene.ini"
expect 8 'ctest --test-dir' test  # the exit code is that of ctest
expect 0 'removed' clean
