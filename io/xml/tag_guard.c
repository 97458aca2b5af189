/* SPDX-License-Identifier: MIT */
/* tag_guard.c - keeps tags from libxml2 that take it long. */
#include "xml/tag_guard.h"

#include <string.h>

enum { IN_TEXT, AT_TAG, IN_TAG, IN_QUOTE, AT_BANG, IN_COMMENT, IN_CDATA, IN_INSTRUCTION };

/* Behind "<!": a comment, CDATA, or a document type, where libxml2 ends. */
static int behind_bang(tag_guard *g, char c) {
  if (g->length == 2 && c == '-' && g->last[1] == '-') {
    return IN_COMMENT;
  }
  if (g->length == 1 && c == '[') {
    return IN_CDATA;
  }
  return c == '>' ? IN_TEXT : AT_BANG;
}

static int after(tag_guard *g, char c) {
  switch (g->where) {
  case AT_TAG:
    g->length = 0;
    g->attributes = 0;
    return c == '!' ? AT_BANG : c == '?' ? IN_INSTRUCTION : c == '>' ? IN_TEXT : IN_TAG;
  case IN_TAG:
    if (c == '"' || c == '\'') {
      g->quote = c;
      g->attributes++;
      return IN_QUOTE;
    }
    return c == '>' ? IN_TEXT : IN_TAG;
  case IN_QUOTE:
    return c == g->quote ? IN_TAG : IN_QUOTE;
  case AT_BANG:
    return behind_bang(g, c);
  case IN_COMMENT:
    return c == '>' && g->last[0] == '-' && g->last[1] == '-' ? IN_TEXT : IN_COMMENT;
  case IN_CDATA:
    return c == '>' && g->last[0] == ']' && g->last[1] == ']' ? IN_TEXT : IN_CDATA;
  case IN_INSTRUCTION:
    return c == '>' && g->last[1] == '?' ? IN_TEXT : IN_INSTRUCTION;
  default:
    return c == '<' ? AT_TAG : IN_TEXT;
  }
}

bool sepax__tag_guard(tag_guard *g, const char *bytes, size_t size) {
  for (size_t n = 0; n < size; n++) {
    if (g->where == IN_TEXT) {
      const char *tag = memchr(bytes + n, '<', size - n);
      if (tag == NULL) {
        g->offset += size - n;
        return true;
      }
      g->offset += (size_t)(tag - bytes) - n;
      n = (size_t)(tag - bytes);
    }
    int before = g->where;
    g->where = after(g, bytes[n]);
    /* The end of a comment has nothing of its beginning: "<!-->" does not end. */
    g->last[0] = before == g->where ? g->last[1] : '\0';
    g->last[1] = before == g->where || g->where == AT_BANG ? bytes[n] : '\0';
    g->offset++;
    if (g->where != IN_TEXT && g->where != IN_CDATA) {
      g->length++;
      if (g->attributes > TAG_ATTRIBUTES_MOST || g->length > TAG_BYTES_MOST) {
        return false;
      }
    }
  }
  return true;
}
