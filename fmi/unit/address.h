/* Where an importer says that the resources are. */
#ifndef HAWSER_FMI_UNIT_ADDRESS_H
#define HAWSER_FMI_UNIT_ADDRESS_H

/* The folder of an address "file:///home/me/a%20pull/resources" or "file:/home/...", malloc'ed; a path that is none is
 * taken as it is, without slashes at its end. NULL: another scheme or host, a malformed escape, nothing, no memory. */
char *address_folder(const char *address);

#endif
