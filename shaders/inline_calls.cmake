# cmake -DSPIRV_OPT=program -DSPIRV=module.spv -P inline_calls.cmake: the module with the bodies of functions in place of
# their calls and without the copies of parameters that calls take: what Mesa does as well, in seven times the time.
# No pass that rewrites arithmetic is among these, so that results keep their bits.
execute_process(
  COMMAND ${SPIRV_OPT} --inline-entry-points-exhaustive --eliminate-dead-functions --convert-local-access-chains
          --eliminate-local-single-block --eliminate-local-single-store --eliminate-dead-code-aggressive
          ${SPIRV} -o ${SPIRV}
  OUTPUT_QUIET  # which functions stay, for they return early
  COMMAND_ERROR_IS_FATAL ANY)
