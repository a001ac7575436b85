# One taxel over the sweep, sampled and by its exact integral, from `bench_artifact FILE`.
# Usage: gnuplot -e "csv='FILE'; out='PICTURE.png'" plot_artifact.gp
if (!exists('csv') || !exists('out')) { exit error "name both: gnuplot -e \"csv='FILE'; out='PICTURE.png'\" plot_artifact.gp" }
set datafile separator ','
set terminal pngcairo size 1400,800 font 'DejaVu Sans,12'
set output out
array title[4] = ['star, few samples', 'star, many samples', 'pad, few samples', 'pad, many samples, Voronoi weights']
array col[4] = [2, 4, 6, 10]
set multiplot layout 2,2
set xlabel 'travel of the finger [mm]'
set ylabel 'pressure [kPa]'
set xrange [7:17]
set yrange [0:*]
set key bottom right
set grid lc rgb '#dddddd'
do for [i = 1:4] {
  c = col[i]
  set title title[i]
  plot csv skip 1 using ($1*1e3):(column(c + 1)*1e-3) with lines lw 2 lc rgb '#bbbbbb' title 'exact integral', \
       csv skip 1 using ($1*1e3):(column(c)*1e-3) with lines lw 1.6 lc rgb '#0072B2' title 'samples'
}
unset multiplot
