# Small multiples of a study: one plot per run, with the same axes and the same colour for each taxel in all plots.
# Usage: gnuplot -e "study='DIR'; base='OUT'" plot_study.gp   reads the folder DIR of `taxel study --out DIR`, writes
# OUT.svg and OUT.png
if (!exists('study')) { exit error "name the folder: gnuplot -e \"study='DIR'; base='OUT'\" plot_study.gp" }
if (!exists('base')) { base = 'study' }
runs = study.'/runs.csv'
if (int(system(sprintf('test -r "%s"; echo $?', runs))) != 0) { exit error sprintf('%s: cannot be read', runs) }
set datafile separator ','
count = int(system(sprintf("tail -n +2 '%s' | wc -l", runs)))
if (count < 1) { exit error sprintf('%s: holds no run', runs) }
cell(line, column) = system(sprintf("sed -n %dp '%s' | cut -d, -f%d", line, runs, column))
file(run) = study.'/'.cell(run + 1, 1)
two = strlen(cell(1, 3)) > 0
title_of(run) = cell(1, 2).' '.cell(run + 1, 2).(two ? ', '.cell(1, 3).' '.cell(run + 1, 3) : '')

first = 8
stats file(1) using 1 skip 1 nooutput
last = STATS_columns
largest = 0
longest = 0
do for [r = 1:count] {
  stats file(r) using 1 skip 1 nooutput
  if (STATS_max > longest) { longest = STATS_max }
  do for [c = first:last] {
    stats file(r) using c skip 1 nooutput
    if (STATS_max > largest) { largest = STATS_max }
  }
}
array responds[last]
do for [c = first:last] {
  responds[c] = 0
  do for [r = 1:count] {
    stats file(r) using c skip 1 nooutput
    if (STATS_max > 0.05 * largest) { responds[c] = 1 }
  }
}
header = file(1)
name(c) = system(sprintf("head -n 1 '%s' | cut -d, -f%d | tr _ ' '", header, c))
array palette[8] = ['#E69F00', '#56B4E9', '#009E73', '#CC79A7', '#0072B2', '#D55E00', '#F0E442', '#000000']

values = int(system(sprintf("tail -n +2 '%s' | cut -d, -f3 | sort -u | wc -l", runs)))
columns = two ? values : int(ceil(sqrt(count)))
rows = (count + columns - 1) / columns
set grid lc rgb '#dddddd'
set border 3 lc rgb '#555555'
set tics nomirror
set key top left Left reverse samplen 1
set xlabel 'time [s]'
set ylabel 'pressure [kPa]'
set xrange [0:longest]
set yrange [0:1.08e-3 * (largest > 0 ? largest : 1000)]

do for [kind in 'svg png'] {
  if (kind eq 'svg') { set terminal svg size 360 * columns,280 * rows font 'DejaVu Sans,11' background '#ffffff' } \
  else { set terminal pngcairo size 360 * columns,280 * rows font 'DejaVu Sans,9' }
  set output base.'.'.kind
  set multiplot layout rows,columns
  do for [r = 1:count] {
    set title title_of(r) noenhanced
    if (r > 1) { unset key }
    plot for [c = first:last] file(r) skip 1 using 1:(responds[c] ? column(c) * 1e-3 : NaN) \
      with lines lw 1.5 lc rgb palette[(c - first) % 8 + 1] title (responds[c] ? name(c) : '')
  }
  unset multiplot
  unset output
  set key top left Left reverse samplen 1
}
