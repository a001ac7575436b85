# Plots the errors of edge_position.py over the spacing of the taxels, one curve for each noise.
# Usage: gnuplot -e "table='table.csv'; base='OUT'; noises='0 0.01'; required=0.5" plot.gp   writes OUT.svg and OUT.png
set datafile separator ','
array colours[5] = ['#009E73', '#0072B2', '#D55E00', '#CC79A7', '#000000']
colour(i) = colours[(i - 1) % 5 + 1]
name(i) = real(word(noises, i)) > 0 ? sprintf('noise of %g %%, 8 bits', 100 * real(word(noises, i))) : 'no noise'
row_of(i, value) = abs(column(1) - real(word(noises, i))) < 1e-9 ? value : NaN
count = words(noises)
set grid ytics lc rgb '#dddddd'
set border 3 lc rgb '#555555'
set tics nomirror
set logscale y
set format y '%g'
set label 1 sprintf('required: %g mm', required) at graph 0.01, first required offset 0, 0.6
set xlabel 'spacing of the taxels [mm]'
set ylabel 'error of the position of the edge [mm]'
set key outside right center vertical Left reverse samplen 3 spacing 1.3
set xrange [*:*] noextend
set offsets graph 0.03, graph 0.03, 0, 0
do for [kind in 'svg png'] {
  if (kind eq 'svg') { set terminal svg size 900,460 font 'DejaVu Sans,12' background '#ffffff' } \
  else { set terminal pngcairo size 1200,620 font 'DejaVu Sans,13' }
  set output base.'.'.kind
  plot for [i = 1:count] table skip 1 using 2:(row_of(i, $5)) with lines lw 2 lc rgb colour(i) title 'RMS, '.name(i), \
       for [i = 1:count] table skip 1 using 2:(row_of(i, $5)):6:7 with yerrorbars pt 7 ps 0.7 lw 1.5 lc rgb colour(i) notitle, \
       for [i = 1:count] table skip 1 using 2:(row_of(i, $8)) with lines dt 2 lw 1.5 lc rgb colour(i) title '95 %, '.name(i), \
       for [i = 1:count] table skip 1 using 2:(row_of(i, $8)):9:10 with yerrorbars pt 6 ps 0.7 lw 1 lc rgb colour(i) notitle, \
       required with lines lw 1.5 dt 4 lc rgb '#000000' notitle
  unset output
}
