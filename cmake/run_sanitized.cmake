# Builds generator, runtime and tests with clang, address and undefined behaviour sanitizers, and runs the tests: every room's code, the runtime,
# emitted code, the command, the fuzzer of the loader, and the freshness of generated/, so that both compilers' generators are known to write the same
# bytes. Left out is what only repeats code that runs anyway, on more, longer or random mechanisms, and the laws of the dynamics, whose code the
# command and generated/ run through; `cmake --workflow --preset asan` runs all of it.
# Arguments: ROOT, BUILD, JOBS: how much it may do at a time.
cmake_minimum_required(VERSION 3.25)
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed: ${ARGN}")
  endif()
endfunction()

# Without optimisation most files compile in less than half the time, and a room at once in half of that: what they include is read once. The
# rooms that the run spends its time in are optimised. LLVM's linker takes a quarter of the time of the usual one. Lines of stacks are a seventh of
# the compiling, and `asan` tells them; warnings are a tenth, and that build and `tidy` give them.
# Of undefined behaviour those kinds are left to the address sanitizer, or to `asan`, that ask about each pointer at each use (null, alignment,
# object-size, vptr): a quarter of the compiling.
set(kinds address bool builtin bounds enum function integer-divide-by-zero nonnull-attribute pointer-overflow return
          returns-nonnull-attribute shift signed-integer-overflow unreachable vla-bound)
list(JOIN kinds "," kinds)
find_program(lld ld.lld)
set(linker)
if(lld)
  set(linker -DCMAKE_EXE_LINKER_FLAGS=-fuse-ld=lld)
endif()
run(${CMAKE_COMMAND} -S ${ROOT} -B ${BUILD} -G Ninja -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Release
    "-DCMAKE_CXX_FLAGS_RELEASE=-O0 -g0 -w" -DALEMBERT_ENGINE_FLAGS=-O1 "-DALEMBERT_ENGINE_ROOMS=symbolic differentiation program registers"
    -DALEMBERT_SANITIZE=${kinds} -DALEMBERT_BUILD_TESTS=ON -DALEMBERT_BUILD_FUZZERS=ON -DALEMBERT_TEST_WHOLE_PROGRAMS=ON -DALEMBERT_BUILD_VIEWER=OFF
    -DALEMBERT_UNITY=ON ${linker})
set(rooms support symbolic differentiation mechanism urdf mjcf sdf osim program emit emitted cli runtime)
list(TRANSFORM rooms PREPEND test_ OUTPUT_VARIABLE programs)
run(${CMAKE_COMMAND} --build ${BUILD} -j${JOBS} --target alembert fuzz_load ${programs})

set(ENV{UBSAN_OPTIONS} print_stacktrace=1)
# Where memory came from is told by a few frames: to note thirty of them at each allocation takes longer.
set(ENV{ASAN_OPTIONS} strict_string_checks=1:detect_stack_use_after_return=1:malloc_context_size=6)
# One mechanism of each kind: all joints, runtime parameters, prescribed motion, a loop in closed form, a shared coordinate, a path, surfaces, a spline,
# rolling, a holonomic loop.
set(ENV{ALEMBERT_CATALOGUE}
    "tree_every_joint runtime_parameters moving_base four_bar_knee rolling_wheels bead_on_helix body_on_torus knee_spline rolling_ball five_bar")
# Chains of a million, XML that grows without bound, a minute of motion, and more random functions and mechanisms, are the same code again. So
# are rounds of one test, and what asks only for numbers or bytes: whether units matter, how far loops go, how exact sines are, where long motions
# end, what follows other files or runs that were killed, the time of a wait, whether two ways to the same code give the same.
set(ENV{ALEMBERT_ONE_ROUND_IN} 6)
set(again *Million* MjcfBombs.* *ForAMinute Chain.* LongChains.* Random/* Seeds/* *ChainWithLoops
          Report.TellsWhichFunctionsHaveLoops Emit.FewDotProductsAreStraightOverManyStates Generate.SameBytesWhereverAndWheneverItRuns
          SinesAndCosines.AreWithinOneUlpNextToQuarterTurns Bench.NothingStaysWhenItIsAskedToEnd
          Simulate.TakesStiffForcesAtTheStepOfAFrame SimulateConstrained.ClosesALoopAndKeepsItClosed Integrate.RepeatedStepsCountTime
          Events.ADroppedBallHitsTheGroundWhenItShould Contacts.ABallThatSlidesRollsInTheEnd LockedFolders.*Killed* Generate.KilledRuns*
          JavaScript.EveryOperation C99.NamesAreTextOnly Rollout.IsTheSameInPacksAndThreads
          Generate.DepfileNamesWhatARobotIsReadFrom Generate.HeadersExplainWhatIsThere Import.HasItsOptionsInEveryCommand
          Import.WritesADescriptionThatOtherCommandsRead Report.SaysThatTheMassMatrixIsNearlySingular Simulate.TimeDoesNotDrift
          Import.IsDoneInSecondsWhateverIsNested Document.RefusesMoreNodesThanTheLimit Evaluate.TakesTimeInProportionToItsInput
          Contacts.APlaneThatMovesIsPushedBack Contacts.SpheresExchangeMomentum Contacts.ABallBouncesWithTheRestitutionOfHuntAndCrossley
          ThelenMuscles.AnIsometricStepEndsAtTheStaticForce ThelenMuscles.ForceOverSpeedAndItsInverseAgree
          MillardMuscles.MoveTheSameByShorterSteps SimulateConstrained.SleighFollowsItsClosedForm Integrate.FreeSpinKeepsEnergyAndMomentum
          SinesAndCosines.AreWithinOneUlpInAllRanges
          SimulateConstrained.RedundantRowsAreNotedOnceAndChangeNothing SimulateConstrained.ImplicitStepsComeToTheSleighsClosedFormByOrderOne
          Simulate.TellsOfStepsThatAreTooLong See.KeepsWhatThereIsOfAMotionThatStops Simulate.ConservesTheEnergyOfADoublePendulum
          Bench.ARobotInAnotherFormatIsImported Bench.ShowsTheFlagsInTheirOrder Memory.LongerFunctionsTakeMore Forces.ATableGivesInputsOverTime
          Import.IsWhatOtherCommandsDoBeforeTheyBegin SearchOrder.* Bench.EveryFunctionHasOperationsCodeAndTime Simplify.GivesUpInTime)
list(JOIN again ":" again)
set(ENV{GTEST_FILTER} "-${again}")
list(JOIN rooms "|" rooms)
run(${CMAKE_CTEST_COMMAND} --test-dir ${BUILD} -j${JOBS} --output-on-failure --no-tests=error -R "^(${rooms}|fuzz\\.load|generated\\.fresh\\..*)$")
