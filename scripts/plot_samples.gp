# Plots the samples of a fingertip and their uniformity, from `taxel validate --samples FILE`.
# Usage: gnuplot -e "csv='FILE'; out='PICTURE.png'" plot_samples.gp
if (!exists('csv') || !exists('out')) { exit error "name both: gnuplot -e \"csv='FILE'; out='PICTURE.png'\" plot_samples.gp" }
set datafile separator ','
set terminal pngcairo size 1400,800 font 'DejaVu Sans,13'
set output out
set multiplot layout 1,2
set title 'polished samples, pad side'
set xlabel 'x [mm]'
set ylabel 'z [mm]' offset 1
set size ratio -1
set cbrange [0.84:1]
set cblabel 'nearest neighbour / densest packing'
set palette defined (0 '#440154', 0.25 '#3b528b', 0.5 '#21918c', 0.75 '#5ec962', 1 '#fde725')
plot csv skip 1 using (strcol(6) eq 'polished' && $2 < 0 ? $1*1e3 : NaN):($3*1e3):4 with points pt 7 ps 0.45 palette notitle
set size noratio
set title 'how often'
set xlabel 'nearest neighbour / densest packing'
set ylabel 'samples'
set key top left
width = 0.01
bin(x) = width * (floor(x / width) + 0.5)
set boxwidth width
set style fill solid 0.6 noborder
plot csv skip 1 using (strcol(6) eq 'polished' ? bin($4) : NaN):(1) smooth frequency with boxes lc rgb '#21918c' title 'polished', \
     csv skip 1 using (strcol(6) eq 'preview' ? bin($4) : NaN):(1) smooth frequency with boxes lc rgb '#e6883c' title 'preview'
unset multiplot
