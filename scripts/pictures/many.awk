# Samples of a skin (taxel samples) as the taxels of a layout on fingertip.obj: as evenly spread as samples are.
BEGIN {
  FS = ","
  print "{\"format\": \"taxel-layout\", \"version\": 1, \"name\": \"Fingertip, 240 taxels\","
  print " \"mesh\": {\"file\": \"fingertip.obj\", \"scale\": [1, 1, 1]},"
  print " \"sampling\": {\"density\": 1e7, \"seed\": 42, \"weights\": \"equal\"},"
  print " \"taxels\": ["
}
NR > 1 {
  printf "%s  {\"id\": %d, \"center\": [%s, %s, %s], \"normal\": [%s, %s, %s], \"radius\": 0.0015}", (NR > 2 ? ",\n" : ""), NR - 2, $1, $2, $3, $4, $5, $6
}
END { print "\n]}" }
