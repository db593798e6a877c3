# Plots what `search_bench picture 33 > scores.csv` wrote: gnuplot bench/search-scores.gp > docs/figures/search-scores.svg
set terminal svg size 640,560 font "sans,13"
set datafile separator ","
set xrange [-0.12:0.65]
set yrange [-0.39:0.39]
set xlabel "from the suspect's own centre towards the true one, mean radii"
set ylabel "across"
set cblabel "standard deviations, harmonics below 64"
set palette defined (0 "#f4f4f4", 0.35 "#9ecae1", 1 "#08306b")
set size ratio -1
set key off
plot "scores.csv" every ::1 using 1:2:3 with image
