/* The languages of a calculation that is handed on; English is what the program says by itself. */
#ifndef HAWSER_DEF_LANGUAGE_H
#define HAWSER_DEF_LANGUAGE_H

typedef enum Language { LANGUAGE_ENGLISH, LANGUAGE_CHINESE, LANGUAGE_GERMAN, LANGUAGES } Language;

#endif
