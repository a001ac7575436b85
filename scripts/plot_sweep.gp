# Plots the responding taxels over the travel of the finger: relative to the largest pressure of the run, and in kPa.
# A taxel whose curve follows the curve of an earlier taxel, its mirror image, has the same colour and a dashed line.
# Usage: gnuplot -e "csv='readings.csv'; base='OUT'" plot_sweep.gp   writes OUT.svg, OUT.png
# With kpa=0 only the upper plot is drawn.
if (!exists('csv')) { exit error "name the readings: gnuplot -e \"csv='readings.csv'; base='OUT'\" plot_sweep.gp" }
if (!exists('base')) { base = 'taxels_over_travel' }
if (!exists('kpa')) { kpa = 1 }
if (int(system(sprintf('test -r "%s"; echo $?', csv))) != 0) { exit error sprintf('%s: cannot be read', csv) }
set datafile separator ','
first = 8
stats csv using 1 skip 1 nooutput
columns = STATS_columns
largest = 0
do for [c = first:columns] { stats csv using c skip 1 nooutput; if (STATS_max > largest) { largest = STATS_max } }
responding = ''
do for [c = first:columns] {
  stats csv using c skip 1 nooutput
  if (STATS_max > 0.05 * largest) { responding = responding.' '.c }
}
name(c) = system(sprintf("head -n 1 '%s' | cut -d, -f%d | tr _ ' '", csv, c))
column_of(i) = int(word(responding, i))

# leader[i] is the earlier curve that curve i follows within a quarter of its peak, or i itself. The window's plot uses
# the same rule (src/core/run/recording/curve_pairs.h).
count = words(responding)
array leader[count > 0 ? count : 1]
do for [i = 1:count] {
  leader[i] = i
  stats csv using column_of(i) skip 1 nooutput
  nearest = 0.25 * STATS_max
  do for [j = 1:i - 1] {
    if (leader[j] == j) {
      stats csv using (abs(column(column_of(i)) - column(column_of(j)))) skip 1 nooutput
      if (STATS_max < nearest) { nearest = STATS_max; leader[i] = j }
    }
  }
}
array light[8] = ['#E69F00', '#56B4E9', '#009E73', '#CC79A7', '#0072B2', '#D55E00', '#F0E442', '#777777']
array dark[8] = ['#7A4B00', '#08527F', '#003D2C', '#6E2F54', '#00243A', '#5C2500', '#6B6400', '#000000']
follows(i) = leader[i] != i
dashes(i) = follows(i) ? 2 : 1
paint(i) = follows(i) ? dark[(leader[i] - 1) % 8 + 1] : light[(i - 1) % 8 + 1]
# Leaders are drawn first, so that the curves that follow them are on top.
order = ''
do for [i = 1:count] { if (!follows(i)) { order = order.' '.i } }
do for [i = 1:count] { if (follows(i)) { order = order.' '.i } }
curve(n) = int(word(order, n))

set grid lc rgb '#dddddd'
set border 3 lc rgb '#555555'
set tics nomirror
set lmargin 9
set key top left Left reverse samplen 3
set xlabel 'travel of the finger [mm]'

height = kpa ? 720 : 420

do for [kind in 'svg png'] {
  if (kind eq 'svg') { set terminal svg size 1000,height font 'DejaVu Sans,13' background '#ffffff' } \
  else { set terminal pngcairo size 1000,height font 'DejaVu Sans,11' }
  set output base.'.'.kind
  if (kpa) { set multiplot layout 2,1 }
  set ylabel 'pressure / largest pressure'
  set yrange [0:1.05]
  plot for [n = 1:count] csv skip 1 using ($2*1e3):(column(column_of(curve(n)))/largest) with lines \
    lw (follows(curve(n)) ? 2 : 4) dt dashes(curve(n)) lc rgb paint(curve(n)) title name(column_of(curve(n)))
  if (kpa) {
    set ylabel 'pressure [kPa]'
    set yrange [0:*]
    plot for [n = 1:count] csv skip 1 using ($2*1e3):(column(column_of(curve(n)))*1e-3) with lines \
      lw (follows(curve(n)) ? 2 : 4) dt dashes(curve(n)) lc rgb paint(curve(n)) notitle
    unset multiplot
  }
  unset output
}
