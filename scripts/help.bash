# Sourced by the scripts: `--help` prints a script's own header and does nothing else.
case "${1:-}" in
  -h | --help)
    sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$0"
    exit
    ;;
esac
