#!/usr/bin/env bash
# completion.bash SCRIPT: what bash offers for lines that begin with translucency, by the completion SCRIPT and the package bash-completion.
# Without bash's strict modes, in which the package does not work.
source /usr/share/bash-completion/bash_completion
source "$1" || exit
failed=0

# offers LINE WORD...: these, in any order, for the last word of the line; the empty one is written ''
offers() {
  local expected
  expected=$(printf '%s\n' "${@:2}" | sort)
  COMP_LINE=$1
  COMP_POINT=${#COMP_LINE}
  # As readline takes lines apart: at blanks and at these.
  mapfile -t COMP_WORDS < <(sed -E "s/([=:]+)/ \1 /g; s/ +/\n/g; s/''//" <<< "${1}")
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  COMPREPLY=()
  _translucency
  if [[ $(printf '%s\n' "${COMPREPLY[@]}" | sed 's/ *$//' | sort -u) != "$expected" ]]; then
    echo "'$1' offers '${COMPREPLY[*]}', expected '${*:2}'" >&2
    failed=1
  fi
}

# Files in an empty folder, in which there are none but these.
cd "$(mktemp -d)" || exit
trap 'rm -r "$PWD"' EXIT
touch frog.json 'left lung.stl'

offers 'translucency r' render run
offers 'translucency --v' --version
offers 'translucency man' # for the build only
offers 'translucency render --technique ad' adaptive additive
offers 'translucency render -t ex' exact
offers 'translucency run --technique=ad' adaptive additive
offers 'translucency compare --techniques exact,ad' exact,adaptive exact,additive
offers 'translucency compare --reference vtk-' vtk-oit vtk-peel
offers 'translucency bench --orb' --orbit
offers 'translucency render --method ' front-to-back dual bucket-sort sum average blended
offers 'translucency render --opacity '
offers 'translucency render --scene f' frog.json
offers 'translucency render l' 'left lung.stl'
offers 'translucency render scene:s' smoke spheres # readline keeps what stands before the colon
offers 'translucency schema ' scene histogram
offers 'translucency list x'
offers 'translucency run ' --
offers 'translucency run --always -- sha256s' sha256sum
exit "$failed"
