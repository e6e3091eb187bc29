# SPDX-License-Identifier: GPL-3.0-or-later
# Bundles the view of a report into one script: cmake -D NPM=... -D FROM=share/report -D IN=scratch -D TO=view.js -P this.
# Without the npm registry there is no view.js, and a warning instead of a failure: all else works without.
set(options --ignore-scripts --no-audit --no-fund --fetch-retries=1 --fetch-timeout=30000)
file(COPY "${FROM}/package.json" "${FROM}/package-lock.json" "${FROM}/bundle.mjs" "${FROM}/src" DESTINATION "${IN}")
if("${FROM}/package-lock.json" IS_NEWER_THAN "${IN}/installed")
  execute_process(COMMAND "${NPM}" ci ${options} WORKING_DIRECTORY "${IN}"
    RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(failed)
    message(WARNING "the view of birdstrike report is not built, as npm could not fetch its packages:\n${said}")
    return()
  endif()
  file(TOUCH "${IN}/installed")
endif()
get_filename_component(folder "${TO}" DIRECTORY)
file(MAKE_DIRECTORY "${folder}")
execute_process(COMMAND "${NPM}" run --silent build -- "${TO}"
  WORKING_DIRECTORY "${IN}" RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(failed)
  message(FATAL_ERROR "the view of birdstrike report cannot be bundled:\n${said}")
endif()
