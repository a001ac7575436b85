# Plots four taxels over the sweep, by samples and by exact integrals, from `bench_artifact FILE`.
# Usage: gnuplot -e "csv='FILE'; out='PICTURE.png'" plot_artifact.gp
if (!exists('csv') || !exists('out')) { exit error "name both: gnuplot -e \"csv='FILE'; out='PICTURE.png'\" plot_artifact.gp" }
set datafile separator ','
set terminal pngcairo size 1400,800 font 'DejaVu Sans,12'
set output out
array title[4] = ['star, few samples', 'star, many samples', 'pad, few samples', 'pad, many samples, Voronoi weights']
array variant[4] = [0, 1, 2, 4]  # columns of the table
array taxel[4] = [3, 4, 9, 10]
array color[4] = [0xD55E00, 0x0072B2, 0xE69F00, 0x56B4E9]
set multiplot layout 2,2
set xlabel 'travel of the finger [mm]'
set ylabel 'pressure [kPa]'
set xrange [7:24]
set yrange [0:*]
set key at graph 0.97, graph 0.71 right Left reverse maxrows 3
set grid lc rgb '#dddddd'
do for [i = 1:4] {
  first = 2 + 8 * variant[i]
  set title title[i]
  plot for [k = 1:4] csv skip 1 using ($1*1e3):(column(first + 2*k - 1)*1e-3) with lines lw 2 lc rgb '#bbbbbb' \
         title (k == 1 ? 'exact integral' : ''), \
       for [k = 1:4] csv skip 1 using ($1*1e3):(column(first + 2*k - 2)*1e-3) with lines lw 1.6 lc rgb color[k] \
         title sprintf('taxel %d', taxel[k])
}
unset multiplot
