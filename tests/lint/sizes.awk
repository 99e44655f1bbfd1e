# Prints the number of lines of each function outside tests, with its place and name: `LINES FILE:LINE NAME`.
# It relies on rustfmt: a function ends at the first line that is its own indentation and a brace.
# A function that is a table, marked by a comment `// table`, ends with ` table`.

FNR == 1 { depth = 0; tests = 0 }
/^#\[cfg\((all\()?test[,)]/ { tests = 1 }
tests { next }

/^ *(pub(\([a-z:_ ]+\))? )?((const|async|unsafe) )*fn [a-z_0-9]+/ {
  indent = $0
  sub(/[^ ].*/, "", indent)
  name = $0
  sub(/.*fn /, "", name)
  sub(/[^a-z_0-9].*/, "", name)
  if (/;$/) next
  depth++
  starts[depth] = FNR; indents[depth] = indent; names[depth] = name; table[depth] = ""
  if (/\}$/) { report(); next }
}
depth && /\/\/ table$/ { table[depth] = " table" }
depth && $0 == indents[depth] "}" { report() }
# The end of a declaration without a body.
depth && index($0, indents[depth] ")") == 1 && /;$/ { depth-- }

function report() {
  print FNR - starts[depth] + 1, FILENAME ":" starts[depth], names[depth] table[depth]
  depth--
}
