# SPDX-License-Identifier: MIT
# sites.awk - where a C file can be changed: a line for each mutant with the line, the column, how
# many characters are replaced, what is there and what comes there instead, separated by tabs.
#
# The layout is that of clang-format: a binary operator has blanks around it. Comments, strings,
# preprocessor lines and declarations of pointers stay; so does a number that, one greater, only
# makes memory longer: in the length of an array that is declared, and in what an allocation asks
# for, but behind a "/" or "-".

BEGIN {
  FS = "\t"
  type = "[A-Za-z_][A-Za-z0-9_]*([(][a-z_0-9]+[)])?"
  count = split("<= < >= > == != && || << >> += -= ++ -- &= |= < > + - * / % & | ^", from, " ")
  split("< <= > >= != == || && >> << -= += -- ++ |= &= <= >= - + + * * | & |", to, " ")
}

function site(column, length_, what, instead) {
  printf "%d\t%d\t%d\t%s\t%s\n", FNR, column, length_, what, instead
}

# The line with blanks in place of comments, strings and characters.
function code_of(line,    out, i, c, quote) {
  out = ""
  for (i = 1; i <= length(line); i++) {
    c = substr(line, i, 1)
    if (comment) {
      if (substr(line, i, 2) == "*/") { comment = 0; out = out "  "; i++ } else out = out " "
    } else if (quote != "") {
      if (c == "\\") { out = out "  "; i++ } else { out = out " "; if (c == quote) quote = "" }
    } else if (substr(line, i, 2) == "/*") { comment = 1; out = out "  "; i++ }
    else if (c == "\"" || c == "'") { quote = c; out = out " " }
    else out = out c
  }
  return out
}

{
  directive = continued || $0 ~ /^ *#/
  continued = directive && $0 ~ /\\$/
  code = code_of($0)
  if (directive || code ~ /^ *(typedef|extern|_Static_assert)/) next

  # Up to which column the line declares; from which it allocates.
  declared = 0
  if (code ~ "^ *((static|const|struct|enum) )*" type "( const)? [*(]*[a-z_]" &&
      code !~ /^[ }]*(if|else|for|while|do|switch|case|goto|return) /) {
    declared = match(code "=", /[={]/)
  }
  allocated = match(code, /[a-z]alloc\(/) ? RSTART : length(code) + 1
  for (i = 1; i <= length(code); i++) {
    c = substr(code, i, 1)
    if (c ~ /[0-9]/ && substr(code, i - 1, 1) !~ /[A-Za-z0-9_.]/) {
      match(substr(code, i), /^[0-9A-Za-z_.]+/)
      number = substr(code, i, RLENGTH)
      before = substr(code, 1, i - 1)
      inside = before ~ /\[[^]]*$/
      longer = inside ? i < declared && before !~ /\)\[/ : i > allocated && before !~ /[-\/] $/
      if (number ~ /^[0-9]+$/ && !longer) site(i, length(number), number, number + 1)
      i += RLENGTH - 1
      continue
    }
    if (c == "!" && substr(code, i + 1, 1) ~ /[A-Za-z_(]/) { site(i, 1, "!", ""); continue }
    if (match(substr(code, i), /^(true|false)/) && substr(code, i - 1, 1) !~ /[A-Za-z0-9_]/ &&
        substr(code, i + RLENGTH, 1) !~ /[A-Za-z0-9_]/) {
      word = substr(code, i, RLENGTH)
      site(i, RLENGTH, word, word == "true" ? "false" : "true")
      i += RLENGTH - 1
      continue
    }
    for (k = 1; k <= count; k++) {
      long = length(from[k])
      if (substr(code, i, long) != from[k]) continue
      around = substr(code, i - 1, 1) == " " && substr(code, i + long, 1) ~ /^ ?$/
      if (around || from[k] == "++" || from[k] == "--") site(i, long, from[k], to[k])
      i += long - 1
      break
    }
  }
  # A statement that is an assignment or a call.
  if (code ~ /^ +[a-z_][A-Za-z0-9_.>\[\]*()& -]*( [-+*\/|&^]?= .*|\(.*\));$/ &&
      code !~ /^ +(return|const|static|int|bool|double|float|size_t|char|long|unsigned|struct) / &&
      code !~ /^ +(enum |u?int[0-9]+_t |[a-z_]+ \*?[a-z_]+ =)/) {
    match(code, /[^ ]/)
    site(RSTART, length(code) - RSTART + 1, "statement", ";")
  }
}
