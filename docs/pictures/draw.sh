#!/usr/bin/env bash
# Draws the pictures of docs/drawing.md anew, each by the command that stands below it there or nearly so.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

draw() {
  local picture=$1
  shift
  cargo run --quiet --release -p dobot-cli -- draw "$@" --dry-run --picture "docs/pictures/$picture"
}

readonly STILL_LIFE=examples/drawings/still-life.jpg
draw harbour.svg examples/drawings/harbour.svg --errors
draw still-life-hatch.svg $STILL_LIFE --shade hatch
draw still-life-lines.svg $STILL_LIFE --shade lines --spacing 2.2
draw still-life-stipple.svg $STILL_LIFE --shade stipple --spacing 1.5
draw still-life-outline.svg $STILL_LIFE --shade outline
draw still-life-spiral.svg $STILL_LIFE --shade spiral --spacing 2.2
draw still-life-flow.svg $STILL_LIFE --shade flow --spacing 1.4
draw still-life-tsp.svg $STILL_LIFE --shade tsp --spacing 1.5
draw hills.svg examples/drawings/hills.svg --hide
draw hatch-concentric.svg examples/drawings/sailing.svg --layers color --hatch 1.2 --hatch-style concentric
draw hatch-spiral.svg examples/drawings/sailing.svg --layers color --hatch 1.2 --hatch-style spiral
draw sailing.svg examples/drawings/sailing.svg --layers color --hatch 1
draw text.svg --text 'Hello, arm' --font script --height 40
draw card.svg --card 2,5,10,20 --laser cardboard-engrave --card-label cardboard-engrave
draw sheet-a4.svg examples/drawings/harbour.svg --paper-size a4 --landscape --margin 10 --fit --clip
draw cutting.svg examples/drawings/gear.plt --laser cardboard-cut --kerf 0.2 --lead-in 3 --overcut 1
