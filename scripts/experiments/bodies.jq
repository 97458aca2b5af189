# SPDX-License-Identifier: MIT
# bodies.jq - the tables of docs/developers/results/bodies.md from build/bodies/bodies.json (jq -r
# -f).
def places($n): . * pow(10; $n) | round / pow(10; $n);
def short: if . >= 100 then places(0) elif . >= 10 then places(1) elif . >= 0.1 then places(2)
  elif . >= 0.01 then places(4) else places(6) end;
def libraries: ["sepax", "FCL", "Coal", "CGAL", "Embree"];
def total(f): map(f) | add;
def of($library): map(select(.library == $library));

# ms a pose, and as multiples of libsepax's; libraries that were not asked have "-".
def cells: . as $rows | (of("sepax") | total(.ms * .count) / total(.count)) as $own
  | libraries | map(. as $library | $rows | of($library) | if length == 0 then "-" else
      (total(.ms * .count) / total(.count)) as $ms
      | if $library == "sepax" then "\($ms | short)" else "\($ms | short), \($ms / $own | short)"
      end end);
def pairs: of("sepax") | total(.pairs) / total(.count) | short;
def row($first): "| " + ($first + cells | join(" | ")) + " |";
def table($what):
  ["| meshes | triangles | poses | \($what) | libsepax | FCL | Coal | CGAL | Embree |",
  "| --- | --- | --- | --- | --- | --- | --- | --- | --- |"] + map(row([.[0].meshes,
  (.[0].triangles | map(tostring) | join(" x ")),
  (if (map(.poses) | unique | length) > 1 then "\(of("sepax") | total(.count))"
   else .[0].poses end), pairs])) | .[];
# Distances alone: no pairs, and only the libraries that measure any.
def measured: map(select(.query == "distance" or .query == "1e-6"))
  | ["| meshes | triangles | poses | libsepax exact | FCL | Coal | libsepax 1e-6 | FCL | Coal |",
     "| --- | --- | --- | --- | --- | --- | --- | --- | --- |"]
    + (group_by([(.unkind | not), .triangles[0] + .triangles[1], .meshes]) | map(. as $rows
      | "| \(.[0].meshes) | \(.[0].triangles | map(tostring) | join(" x ")) | "
        + "\(map(select(.query == "distance")) | of("sepax") | total(.count)) | "
        + (["distance", "1e-6"] | map(. as $query | $rows | map(select(.query == $query))
           | cells[:3]) | add | join(" | ")) + " |")) | .[];
def bodies: group_by([.triangles[0] + .triangles[1], .meshes]);

. as $all
| [.rows[] | select(.poses | test("one-shot") or . == "contact" | not)] as $distances
| [$distances[] | select(.unkind | not)] as $kinds
| [.rows[] | select(.poses == "contact" and .query == "all")] as $contact
| [.rows[] | select(.poses | test("one-shot"))] as $once
| "## First hit\n", ($kinds | map(select(.query == "first")) | bodies | table("hits")),
  "\n## All pairs\n", ($kinds | map(select(.query == "all")) | bodies | table("pairs")),
  "\nIn contact:\n", ($contact | bodies | table("pairs")),
  "\n## Distance\n", ($distances | measured),
  "\n## Once\n", ($once | group_by([.triangles[0] + .triangles[1], .meshes, .poses])
    | table("pairs")),
  "\n## Wrong verdicts\n", "| meshes | poses | query | library | poses | wrong |",
  "| --- | --- | --- | --- | --- | --- |",
  ($all.rows[] | select(.wrong > 0)
    | "| \(.meshes) | \(.poses) | \(.query) | \(.library) | \(.count) | \(.wrong) |")
