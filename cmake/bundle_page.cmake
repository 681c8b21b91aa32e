# cmake -DNPM=... -DNODE=... -DWEB=... -DOUTPUT=... -P bundle_page.cmake: makes the page of reports
# from web/ beside OUTPUT. Without npm, or where that fails, OUTPUT is empty.
get_filename_component(folder ${OUTPUT} DIRECTORY)
file(MAKE_DIRECTORY ${folder})

function(give_up reason)
  message("Without the page of `starling report`: ${reason}")
  file(WRITE ${OUTPUT} "")
endfunction()

if(NOT NPM OR NOT NODE)
  give_up("npm is not installed (tools/install_packages web)")
  return()
endif()

file(COPY ${WEB}/package.json ${WEB}/package-lock.json ${WEB}/.npmrc DESTINATION ${folder})
execute_process(COMMAND ${NPM} ci --fetch-retries=1
  WORKING_DIRECTORY ${folder} RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(failed)
  give_up("npm ci failed\n${said}")
  return()
endif()

# Modules are found from where the sources are.
file(COPY ${WEB}/bundle.mjs ${WEB}/src DESTINATION ${folder})
execute_process(COMMAND ${NODE} bundle.mjs ${OUTPUT}
  WORKING_DIRECTORY ${folder} RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(failed)
  give_up("bundling failed\n${said}")
endif()
