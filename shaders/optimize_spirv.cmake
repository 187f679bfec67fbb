# cmake -DFOR=MESA|SWIFTSHADER -DSPIRV_OPT=program -DSPIRV=module.spv -P optimize_spirv.cmake: the module with the bodies of
# functions in place of their calls and without the copies of parameters that calls take, which takes drivers long.
# No pass that rewrites arithmetic is among these, so that results keep their bits.
if(FOR STREQUAL MESA)
  # It makes registers of variables by itself, and faster code.
  set(passes --inline-entry-points-exhaustive --eliminate-dead-functions --convert-local-access-chains
             --eliminate-local-single-block --eliminate-local-single-store --eliminate-dead-code-aggressive)
else()
  # Those of spirv-opt -O, without --simplify-instructions and --ccp.
  set(forwarding --scalar-replacement=100 --convert-local-access-chains --eliminate-local-single-block
                 --eliminate-local-single-store --eliminate-dead-code-aggressive --ssa-rewrite --eliminate-dead-code-aggressive)
  set(passes --eliminate-dead-branches --merge-return --inline-entry-points-exhaustive --eliminate-dead-functions
             --eliminate-dead-code-aggressive --private-to-local --eliminate-local-single-block --eliminate-local-single-store
             ${forwarding} --eliminate-dead-branches --redundancy-elimination --combine-access-chains
             ${forwarding} --vector-dce --eliminate-dead-inserts --eliminate-dead-branches
             --if-conversion --copy-propagate-arrays --reduce-load-size --eliminate-dead-code-aggressive --merge-blocks
             --redundancy-elimination --eliminate-dead-branches --merge-blocks)
endif()
execute_process(COMMAND ${SPIRV_OPT} ${passes} ${SPIRV} -o ${SPIRV}
  OUTPUT_QUIET  # which functions stay, for they return early
  COMMAND_ERROR_IS_FATAL ANY)
