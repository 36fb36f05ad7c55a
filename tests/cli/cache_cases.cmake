# What `coif cache` takes, refuses and says.
string(REPEAT 0 30 zeros)
string(REPEAT 1 32 ones)
set(entry "cache/00/${zeros}/${ones}.entry")
coif_cli_case(cache_stats EXIT 0 STDOUT "^cache: 1 entry of 1 source, 12 bytes\n  last used 0 minutes to 0 minutes ago\n$"
  TEXT ${entry} "twelve bytes" ARGS cache --dir cache --stats)
coif_cli_case(cache_max_size EXIT 0
  STDOUT "^cache: removed 1 entry, 12 bytes, and 0 files of killed cooks\ncache: 0 entries of 0 sources, 0 bytes\n$"
  TEXT ${entry} "twelve bytes" cache/notes.txt "mine" ARGS cache --dir cache --max-size 0)
coif_cli_case(cache_json EXIT 0
  JSON sources entries bytes leftovers leftover_bytes removed_entries removed_bytes removed_leftovers oldest_use_s newest_use_s
  TEXT ${entry} "twelve bytes" ARGS cache --dir cache --max-size 1.5Ki --stats --format json)
coif_cli_case(cache_without_work EXIT 1 STDERR "needs --stats, --max-size or both" TEXT ${entry} "twelve bytes" ARGS cache --dir cache)
coif_cli_case(cache_absent EXIT 2 STDERR "coif cache: error: gone: cannot read the cache: No such file or directory"
  ARGS cache --dir gone --stats)
foreach(size -1 G 10X 1e30T " 5" nan)
  string(MAKE_C_IDENTIFIER "cache_size_${size}" name)
  coif_cli_case(${name} EXIT 1 STDERR "'${size}' is no size, such as 10G, 512M or 1.5Gi" ARGS cache --dir . "--max-size=${size}")
endforeach()
