# The taxels that respond, over the travel of the finger: divided by the largest pressure of the run, and in kPa.
# Usage: gnuplot -e "csv='readings.csv'; base='OUT'" plot_sweep.gp   writes OUT.svg, OUT.png
if (!exists('csv')) { exit error "name the readings: gnuplot -e \"csv='readings.csv'; base='OUT'\" plot_sweep.gp" }
if (!exists('base')) { base = 'taxels_over_travel' }
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
header = system(sprintf("head -n 1 '%s'", csv))
name(c) = system(sprintf("head -n 1 '%s' | cut -d, -f%d | tr _ ' '", csv, c))
array palette[8] = ['#E69F00', '#56B4E9', '#009E73', '#CC79A7', '#0072B2', '#D55E00', '#F0E442', '#000000']

set grid lc rgb '#dddddd'
set border 3 lc rgb '#555555'
set tics nomirror
set lmargin 9
set key top left Left reverse samplen 2
set xlabel 'travel of the finger [mm]'

do for [kind in 'svg png'] {
  if (kind eq 'svg') { set terminal svg size 1000,720 font 'DejaVu Sans,13' background '#ffffff' } \
  else { set terminal pngcairo size 1000,720 font 'DejaVu Sans,11' }
  set output base.'.'.kind
  set multiplot layout 2,1
  set ylabel 'pressure / largest pressure'
  set yrange [0:1.05]
  plot for [i = 1:words(responding)] csv skip 1 using ($2*1e3):(column(int(word(responding, i)))/largest) \
    with lines lw 2 lc rgb palette[(i - 1) % 8 + 1] title name(int(word(responding, i)))
  set ylabel 'pressure [kPa]'
  set yrange [0:*]
  plot for [i = 1:words(responding)] csv skip 1 using ($2*1e3):(column(int(word(responding, i)))*1e-3) \
    with lines lw 2 lc rgb palette[(i - 1) % 8 + 1] notitle
  unset multiplot
  unset output
}
