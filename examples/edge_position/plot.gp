# Plots the errors of edge_position.py over the spacing of the taxels, one colour for each noise.
# Usage: gnuplot -e "table='table.csv'; base='OUT'; noises='0 0.01'; required=0.5" plot.gp   writes OUT.svg and OUT.png
set datafile separator ','
array colours[5] = ['#009E73', '#0072B2', '#D55E00', '#CC79A7', '#000000']
colour(i) = colours[(i - 1) % 5 + 1]
noise(i) = real(word(noises, i))
name(i) = noise(i) > 0 ? sprintf('noise of %g %%, 8 bits', 100 * noise(i)) : 'no noise'
only(i, value) = abs(column(1) - noise(i)) < 1e-9 ? value : NaN  # column 1: noise
count = words(noises)
set grid ytics lt 1 lw 1 lc rgb '#dddddd'
set border 3 lc rgb '#555555'
set tics nomirror
set logscale y
set format y '%g'
set xlabel 'spacing of the taxels [mm]'
set ylabel 'error of the position of the edge [mm]'
set label 1 sprintf('required: %g mm', required) at graph 0.01, first required offset 0, 0.6
set key bottom right Left reverse samplen 3 spacing 1.2
set xrange [*:*] noextend
set offsets graph 0.03, graph 0.03, 0, 0
do for [kind in 'svg png'] {
  if (kind eq 'svg') { set terminal svg size 820,520 font 'DejaVu Sans,12' background '#ffffff' } \
  else { set terminal pngcairo size 1100,700 font 'DejaVu Sans,14' }
  set output base.'.'.kind
  # columns 2: spacing, 5 to 7: RMS with its interval, 8 to 10: error of 95 % with its interval
  plot for [i = 1:count] table skip 1 using 2:(only(i, $8)) with lines dt 2 lw 1.5 lc rgb colour(i) title '95 % of touches within, '.name(i), \
       for [i = 1:count] table skip 1 using 2:(only(i, $8)):9:10 with yerrorbars pt 6 ps 0.7 lw 1 lc rgb colour(i) notitle, \
       for [i = 1:count] table skip 1 using 2:(only(i, $5)) with lines lw 2 lc rgb colour(i) title 'RMS error, '.name(i), \
       for [i = 1:count] table skip 1 using 2:(only(i, $5)):6:7 with yerrorbars pt 7 ps 0.7 lw 1.5 lc rgb colour(i) notitle, \
       required with lines lw 1.5 dt 4 lc rgb '#000000' notitle
  unset output
}
