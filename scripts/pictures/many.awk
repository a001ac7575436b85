# Converts samples of a skin (`taxel samples`) into taxels of a layout on fingertip.obj. The taxels are spread like the
# samples.
#   -v density=1e7 -v radius=0.0015   density of the layout [1/m^2], radius of its taxels [m]
BEGIN {
  FS = ","
  if (density == "") density = "1e7"
  if (radius == "") radius = "0.0015"
  print "{\"format\": \"taxel-layout\", \"version\": 1, \"name\": \"Fingertip, many taxels\","
  print " \"mesh\": {\"file\": \"fingertip.obj\", \"scale\": [1, 1, 1]},"
  print " \"sampling\": {\"density\": " density ", \"seed\": 42, \"weights\": \"equal\"},"
  print " \"taxels\": ["
}
NR > 1 {
  printf "%s  {\"id\": %d, \"center\": [%s, %s, %s], \"normal\": [%s, %s, %s], \"radius\": %s}", (NR > 2 ? ",\n" : ""), NR - 2, $1, $2, $3, $4, $5, $6, radius
}
END { print "\n]}" }
