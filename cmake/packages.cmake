# scripts/package.sh makes one Debian package with the programs, the units, the alerts, the dashboard, the documents and
# the licences (`cpack -G DEB --config build/release/CPackConfig.cmake`).
install(FILES deploy/systemd/tilemend-coordinator.service deploy/systemd/tilemend-worker.service
  DESTINATION lib/systemd/system)
install(DIRECTORY deploy/prometheus deploy/grafana deploy/kubernetes deploy/slurm DESTINATION share/doc/tilemend/deploy
  USE_SOURCE_PERMISSIONS PATTERN "*.py" EXCLUDE PATTERN "tls" EXCLUDE)
install(DIRECTORY docs examples DESTINATION share/doc/tilemend USE_SOURCE_PERMISSIONS PATTERN "__pycache__" EXCLUDE)
install(PROGRAMS scripts/make_certificates.sh scripts/render.py DESTINATION share/doc/tilemend/scripts)
install(DIRECTORY proto DESTINATION share/doc/tilemend FILES_MATCHING PATTERN "*.proto")  # for programs that call the API
install(FILES scripts/packages.txt DESTINATION share/doc/tilemend/scripts)
install(FILES README.md CHANGELOG.md CONTRIBUTING.md LICENSE NOTICE SECURITY.md THIRD_PARTY.md DESTINATION share/doc/tilemend)

set(CPACK_PACKAGE_NAME tilemend)
set(CPACK_RESOURCE_FILE_LICENSE ${CMAKE_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGE_CONTACT "tilemend <tilemend@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Fills the holes of very large triangle meshes that are stored as tiles")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# What `shlibdeps` does not see: the data of PROJ, and useradd.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "proj-data, passwd")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "openssl")
set(debian ${CMAKE_SOURCE_DIR}/deploy/debian)
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${debian}/conffiles ${debian}/postinst ${debian}/prerm ${debian}/postrm)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# Of the package alone: `cmake --install` writes nothing to /etc.
install(FILES ${debian}/coordinator.conf ${debian}/worker.conf DESTINATION /etc/tilemend
  COMPONENT settings EXCLUDE_FROM_ALL)
set(CPACK_INSTALL_CMAKE_PROJECTS "${CMAKE_BINARY_DIR};tilemend;ALL;/;${CMAKE_BINARY_DIR};tilemend;settings;/")
include(CPack)
