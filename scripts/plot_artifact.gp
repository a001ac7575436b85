# Readings that jump, and the exact integral of the same contact, from `taxel validate --artifact FILE`.
# Usage: gnuplot -e "csv='FILE'; out='PICTURE.png'" plot_artifact.gp
if (!exists('csv') || !exists('out')) { exit error "name both: gnuplot -e \"csv='FILE'; out='PICTURE.png'\" plot_artifact.gp" }
set datafile separator ','
set terminal pngcairo size 1400,800 font 'DejaVu Sans,12'
set output out
set multiplot layout 2,2
set xlabel 'travel [mm]'
set ylabel 'reading [kPa]'
set key top left
set yrange [0:*]
do for [run = 0:3] {
  title = system(sprintf("head -1 '%s' | cut -d '\"' -f %d", csv, 2 * run + 2))
  set title title
  plot csv skip 1 using 1:(column(2 * run + 2)) with steps lw 2 lc rgb '#d55e00' title 'samples', \
       csv skip 1 using 1:(column(2 * run + 3)) with lines lw 2 lc rgb '#0072b2' title 'exact integral'
}
unset multiplot
